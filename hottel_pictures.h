// Pictures of scenes in the plane, of their light and of what is seen in them.
#pragma once

#include "viewer/picture/plane/illumination_picture.h"  // illumination_picture_2, light_painter_2
#include "viewer/picture/plane/scene_picture.h"         // scene_picture_2
#include "viewer/picture/plane/visibility_picture.h"    // visibility_picture_2, pair_picture_2
