#include "paper/vertex"
