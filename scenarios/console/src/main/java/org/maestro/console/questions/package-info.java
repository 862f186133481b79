/**
 * What people and programs ask a running platform. Questions go in by name, to the agents that can
 * answer them; JSON documents come out, the same ones for the command line and for the API. It
 * knows how messages are worded, and neither how a question came in nor how its answer is shown.
 */
@NullMarked
package org.maestro.console.questions;

import org.jspecify.annotations.NullMarked;
