/** Text of others as people and their terminals may have it, printed or kept in files. */
package org.maestro.text;
