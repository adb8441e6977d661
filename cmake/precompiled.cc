// Nothing: the precompiled headers of the rooms belong to a target, and a target has a source.
