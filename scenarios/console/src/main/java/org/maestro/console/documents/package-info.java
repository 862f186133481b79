/**
 * JSON documents of what a platform tells, as the schemas in {@code docs/schemas} describe them.
 * What agents answer goes in as words, or what is known as beliefs; documents come out. Nobody is
 * asked here.
 */
@NullMarked
package org.maestro.console.documents;

import org.jspecify.annotations.NullMarked;
