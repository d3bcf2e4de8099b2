/** Loads what materials import when they are made: an import that outlives its test file would fail in all later files of the process. */
import.meta.glob('../../src/material/parts/*.ts', { eager: true });
