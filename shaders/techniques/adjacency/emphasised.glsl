#include "perTriangle/emphasised"
