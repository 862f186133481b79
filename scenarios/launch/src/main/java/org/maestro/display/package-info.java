/**
 * Text of others where people read it: names, labels and sentences come from homes, devices and
 * other agents, and what steers a terminal, or feigns a line of its own, is shown in them instead
 * of done. Everything that is printed, logged or put on a page passes here once.
 */
@NullMarked
package org.maestro.display;

import org.jspecify.annotations.NullMarked;
