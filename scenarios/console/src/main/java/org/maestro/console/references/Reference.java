package org.maestro.console.references;

/**
 * One component that turns to another.
 *
 * @param from the id of the one that has the reference
 * @param to the id of the one that it points to
 * @param purpose what for, in words
 */
record Reference(String from, String to, String purpose) {}
