/**
 * What is made of many runs: tables of raw data as CSV, means with their spread, and shares with
 * the interval in which the true one lies. The same data give the same bytes.
 */
@NullMarked
package org.maestro.experiment.measuring;

import org.jspecify.annotations.NullMarked;
