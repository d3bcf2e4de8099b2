#include "paper/deform"
