/**
 * What was so before the steps of goals changed it, so that it can be made so again. Orders flow in
 * as they are sent and answered; what is to be so again, as a formula like any goal, flows out. It
 * knows no goal but by its name, and undoes nothing itself.
 */
@NullMarked
package org.maestro.coordination.undoing;

import org.jspecify.annotations.NullMarked;
