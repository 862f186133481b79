/**
 * What of an experiment can be set on the command line, and what it means for the physics of the
 * simulated world. Texts flow in, checked numbers flow out; what is wrong is said in one sentence.
 */
@NullMarked
package org.maestro.experiment.setting;

import org.jspecify.annotations.NullMarked;
