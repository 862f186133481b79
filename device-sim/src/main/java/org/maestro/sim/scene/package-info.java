/**
 * What a scene states: where things are, what they look like, the sky, and which faults strike
 * when. Turtle and a home flow in; an immutable scene, or one sentence that says what is wrong with
 * it, flows out. It knows no world that runs.
 */
@NullMarked
package org.maestro.sim.scene;

import org.jspecify.annotations.NullMarked;
