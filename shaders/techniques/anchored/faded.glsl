#include "perFragment/faded"
