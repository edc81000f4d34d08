#include "scenes/readers/mesh.h"
