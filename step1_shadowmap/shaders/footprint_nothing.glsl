// For --dump where no lookup asks how far apart the pixels are in the map.

vec4 footprint(Receiver receiver)
{
    return vec4(0.0);
}
