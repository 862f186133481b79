/**
 * What others tell the collective knowledge and hear from it: beliefs with their sources, results
 * of features, snapshots, disputes, history. It says nothing of how they are kept.
 */
@NullMarked
package org.maestro.knowledge.api;

import org.jspecify.annotations.NullMarked;
