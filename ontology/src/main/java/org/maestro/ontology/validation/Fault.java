package org.maestro.ontology.validation;

/**
 * Something wrong in a vocabulary, home file or description.
 *
 * @param source file name, or who sent the text
 * @param line from 1; 0 when the text has no lines to speak of
 * @param subject local name of what is spoken of
 * @param property prefixed name, or "" when the fault is in the subject as a whole
 * @param problem what is wrong, read after subject and property
 * @param cure what would be right
 */
public record Fault(
    String source, int line, String subject, String property, String problem, String cure) {

  /**
   * One line, such as {@code bob.ttl:41: lamp-b1 maestro:beamAngle "abc" is not a number; write
   * degrees, such as 100}.
   */
  @Override
  public String toString() {
    String where = line > 0 ? source + ":" + line : source;
    String what = property.isEmpty() ? subject : subject + " " + property;
    return (where + ": " + what + " " + problem + "; " + cure).replaceAll("\\s+", " ");
  }
}
