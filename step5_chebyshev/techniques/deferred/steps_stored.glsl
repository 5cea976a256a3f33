// The position's derivatives from the G-buffer, see gbuffer_steps.glsl.
// needs: nothing
// offers: to_right, to_above

uniform sampler2D stored_right;
uniform sampler2D stored_above;

vec3 to_right = texelFetch(stored_right, ivec2(gl_FragCoord.xy), 0).xyz;
vec3 to_above = texelFetch(stored_above, ivec2(gl_FragCoord.xy), 0).xyz;
