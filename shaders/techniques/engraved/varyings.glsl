#include "perFragment/varyings"
