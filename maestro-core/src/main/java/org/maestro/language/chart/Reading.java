package org.maestro.language.chart;

import org.maestro.language.grammar.Form;

/**
 * What words may mean.
 *
 * @param penalty how unusual the wording would be
 */
public record Reading(Form form, int penalty) {}
