package org.maestro.language.grammar;

/**
 * How a report that is written in another language is said in this one: {@code report Fact
 * {x:thing} is missing => {x} fehlt}.
 *
 * @param category what kind of report, or of part of one, it says
 * @param text as it is written, with places such as {@code {x:thing}} for what changes: their name
 *     and their category
 * @param result the same in this language, with the names of places, or what it means in MAESTRO-SL
 * @param formula whether it is the latter
 * @param line of the grammar
 */
public record ReportRule(String category, String text, String result, boolean formula, int line) {}
