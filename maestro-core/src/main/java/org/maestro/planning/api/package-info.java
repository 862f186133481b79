/**
 * What is to be planned and what planning ends with: tasks, priced features, objectives, plans,
 * reasons and choices. It knows nothing of how a plan is found.
 */
@NullMarked
package org.maestro.planning.api;

import org.jspecify.annotations.NullMarked;
