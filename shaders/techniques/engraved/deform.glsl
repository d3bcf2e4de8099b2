#include "deformVertex"
