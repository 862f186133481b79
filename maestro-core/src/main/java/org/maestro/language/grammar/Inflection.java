package org.maestro.language.grammar;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * How words change their form: regular endings by patterns, others one by one. Forms have names,
 * such as {@code ing}. Immutable.
 */
public final class Inflection {
  private final Map<String, List<Ending>> endings;
  private final Map<String, Map<String, String>> irregular;

  /** What becomes of a word that the pattern fits. */
  record Ending(Pattern fits, String replacement) {}

  /**
   * @param endings by the form's name; the first that fits counts
   * @param irregular by the form's name and the word
   */
  Inflection(Map<String, List<Ending>> endings, Map<String, Map<String, String>> irregular) {
    this.endings = new LinkedHashMap<>(endings);
    this.irregular = new LinkedHashMap<>(irregular);
  }

  /** The names of all forms. */
  public List<String> forms() {
    List<String> names = new ArrayList<>(endings.keySet());
    irregular.keySet().stream().filter(name -> !names.contains(name)).forEach(names::add);
    return names;
  }

  /** The word in that form; the word itself when nothing is said of it. */
  public String of(String word, String form) {
    String exception = irregular.getOrDefault(form, Map.of()).get(word);
    if (exception != null) {
      return exception;
    }
    return endings.getOrDefault(form, List.of()).stream()
        .filter(ending -> ending.fits().matcher(word).find())
        .findFirst()
        .map(ending -> ending.fits().matcher(word).replaceFirst(ending.replacement()))
        .orElse(word);
  }
}
