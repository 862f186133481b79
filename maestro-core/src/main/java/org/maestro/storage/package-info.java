/**
 * Writing to disks that may be slow or refuse: beside those who have something written, and with
 * what is wrong in words.
 */
@NullMarked
package org.maestro.storage;

import org.jspecify.annotations.NullMarked;
