package org.maestro.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Gives words of Turtle and MAESTRO-SL other words, and takes them back out of what is told. */
final class Renaming {

  private static final Pattern DECLARED = Pattern.compile("(?m)^:([A-Za-z]\\w*)\\s+a\\s");
  private static final Pattern DEVICE = Pattern.compile("(?m)^home:([\\w-]+)\\s+a\\s+:(\\w+)");

  /** Comment, long text, text, IRI, prefixed name, anything else. */
  private static final Pattern TURTLE =
      Pattern.compile(
          "(?<comment>(?m:#[^\\n]*$))"
              + "|(?<long>\"\"\"(?s:.*?)\"\"\")"
              + "|(?<text>\"(?:[^\"\\\\]|\\\\.)*\")"
              + "|(?<iri><[^>\\s]*>)"
              + "|(?<name>[A-Za-z]*:[A-Za-z][\\w-]*)");

  private static final Set<String> FORMULAS =
      Set.of(
          "maestro:arguments",
          "maestro:derivedWhen",
          "maestro:observedWhen",
          "maestro:likelyWhen",
          "maestro:precondition",
          "maestro:effect",
          "maestro:learns",
          "maestro:number",
          "maestro:times",
          "maestro:cost",
          "maestro:costAtLeast",
          "maestro:seconds",
          "maestro:fact",
          "maestro:variable",
          "maestro:when");

  private static final Pattern WORD = Pattern.compile("[?]?[A-Za-z][A-Za-z0-9_-]*");

  private final Map<String, String> newByOld = new TreeMap<>();
  private final Map<String, String> oldByNew = new TreeMap<>();

  private Renaming(Set<String> words, Random random) {
    for (String word : words) {
      String other;
      do {
        other = word(random);
      } while (oldByNew.containsKey(other) || words.contains(other));
      newByOld.put(word, other);
      oldByNew.put(other, word);
    }
  }

  /** A random word for each word that the vocabulary declares, and for each device of the home. */
  static Renaming of(String vocabulary, String home, Set<String> deviceClasses, long seed) {
    Set<String> words = new TreeSet<>();
    Matcher declared = DECLARED.matcher(vocabulary);
    while (declared.find()) {
      words.add(declared.group(1));
    }
    Matcher device = DEVICE.matcher(home);
    while (device.find()) {
      if (deviceClasses.contains(device.group(2))) {
        words.add(device.group(1));
      }
    }
    return new Renaming(words, new Random(seed));
  }

  Set<String> words() {
    return newByOld.keySet();
  }

  String renamed(String word) {
    return newByOld.getOrDefault(word, word);
  }

  /** A vocabulary, home or scene: names, and words of formulas; texts for people stay. */
  String turtle(String text) {
    StringBuilder result = new StringBuilder();
    Matcher token = TURTLE.matcher(text);
    String property = "";
    int end = 0;
    while (token.find()) {
      result.append(text, end, token.start());
      end = token.end();
      if (token.group("name") != null) {
        property = token.group();
        int colon = property.indexOf(':');
        String prefix = property.substring(0, colon);
        String name = property.substring(colon + 1);
        boolean ours = prefix.isEmpty() || prefix.equals("home");
        result.append(prefix).append(':').append(ours ? renamed(name) : name);
      } else if (token.group("iri") != null && token.group().startsWith("<#")) {
        result.append("<#").append(renamed(token.group().replaceAll("[<#>]", ""))).append('>');
      } else if ((token.group("long") != null || token.group("text") != null)
          && FORMULAS.contains(property)) {
        result.append(formula(token.group()));
      } else {
        result.append(token.group());
      }
    }
    return result.append(text.substring(end)).toString();
  }

  /** Words of MAESTRO-SL; variables stay. */
  String formula(String text) {
    return replaced(text, newByOld);
  }

  /** What is told in the new words, told in the old ones. */
  String undone(String told) {
    return replaced(told, oldByNew);
  }

  private static String replaced(String text, Map<String, String> words) {
    return WORD.matcher(text)
        .replaceAll(
            found -> Matcher.quoteReplacement(words.getOrDefault(found.group(), found.group())));
  }

  private static String word(Random random) {
    List<String> syllables = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      syllables.add(
          "bdfgklmnprstvz".charAt(random.nextInt(14)) + "" + "aeiou".charAt(random.nextInt(5)));
    }
    return String.join("", syllables);
  }
}
