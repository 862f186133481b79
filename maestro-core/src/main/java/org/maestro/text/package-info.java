/** Text of others as people and their terminals may have it, printed or kept in files. */
@NullMarked
package org.maestro.text;

import org.jspecify.annotations.NullMarked;
