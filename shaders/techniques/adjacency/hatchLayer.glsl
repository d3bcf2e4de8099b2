#include "paper/hatchLayer"
