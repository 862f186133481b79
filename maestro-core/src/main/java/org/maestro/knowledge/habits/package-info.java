/**
 * Habits: how often something has become so at about this time of day, counted from what happens
 * (ADE, 4.1; A57). Changes of the knowledge flow in; numbers flow back as facts, and each count
 * into a file. It does not know what is counted: the home's words say so.
 */
@NullMarked
package org.maestro.knowledge.habits;

import org.jspecify.annotations.NullMarked;
