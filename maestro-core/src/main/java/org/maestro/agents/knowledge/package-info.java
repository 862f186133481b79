/**
 * The collective knowledge as agents elsewhere read it, what of it is private to whom, and who is
 * told when an answer changes. Questions flow in; answers and news of them flow out. What is true
 * is decided where it is kept.
 */
@NullMarked
package org.maestro.agents.knowledge;

import org.jspecify.annotations.NullMarked;
