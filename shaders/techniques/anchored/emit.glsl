#include "perFragment/emit"
