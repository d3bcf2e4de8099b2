// None: families of lines cross within the one layer.
