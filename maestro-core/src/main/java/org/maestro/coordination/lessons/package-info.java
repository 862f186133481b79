/**
 * What steps have taught of members beyond their descriptions: failures that are not repeated on
 * unchanged facts, conditions that members insist on, results that teach nothing. Reports flow in;
 * barred steps, further conditions and features to be left alone flow out. It knows no plan.
 */
@NullMarked
package org.maestro.coordination.lessons;

import org.jspecify.annotations.NullMarked;
