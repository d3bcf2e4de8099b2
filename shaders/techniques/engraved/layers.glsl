// No layers: families of lines cross within one layer.
