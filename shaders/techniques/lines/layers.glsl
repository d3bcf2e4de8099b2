// Families of lines cross within one layer.
