#include "perFragment/emphasised"
