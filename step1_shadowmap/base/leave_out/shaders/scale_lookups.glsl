// None is grey, one is orange, two are blue; part is half of their number.
// needs: nothing
// offers: scale_color

vec3 scale_color(float part)
{
    return part < 0.25 ? vec3(0.5)
           : part < 0.75 ? vec3(0.9, 0.4, 0.1) : vec3(0.2, 0.4, 0.9);
}
