package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;

/** Takes texts apart into words as lexicon and grammar write them. Immutable. */
public final class Tokens {
  /** What stands for a word that was broken off. */
  public static final String CUT_OFF = "-";

  /** A short stop within a sentence. */
  public static final String BREATH = ",";

  /** Longer words than any language has are cut; nobody means them. */
  private static final int LONGEST_WORD = 64;

  private static final Comparator<String> LONGEST_FIRST =
      Comparator.comparing(String::length).reversed().thenComparing(text -> text);

  private static final Pattern BLANKS = Pattern.compile("[\\s\\p{Cntrl}\\p{Cf}]+");
  private static final Pattern NUMBER_AND_UNIT = Pattern.compile("(?<=\\d)(?=[\\p{L}%°])");
  private static final Pattern ENDS = Pattern.compile("[.!?;:\"“”„()\\[\\]{}]+$");
  private static final Pattern BEGINNINGS = Pattern.compile("^[\"“”„(\\[{¿¡]+");

  /** Stands in a spelling for what goes before an ending, or behind a beginning. */
  private static final String REST = "~";

  private final Map<String, String> spellings;
  private final Map<String, String> endings = new TreeMap<>(LONGEST_FIRST);
  private final Map<String, String> beginnings = new TreeMap<>(LONGEST_FIRST);

  /**
   * @param spellings words that are written otherwise first; one that begins with ~ is the end of a
   *     word, one that ends with ~ its beginning, where ~ is the rest of it
   */
  public Tokens(Map<String, String> spellings) {
    this.spellings = Map.copyOf(spellings);
    spellings.forEach(
        (written, meant) -> {
          if (written.startsWith(REST)) {
            endings.put(written.substring(REST.length()), meant);
          } else if (written.endsWith(REST)) {
            beginnings.put(written.substring(0, written.length() - REST.length()), meant);
          }
        });
  }

  /** The words of a text, in small letters. */
  public List<String> of(String text) {
    List<String> words = new ArrayList<>();
    String clean =
        text.replace('\u2019', '\'')
            .replace("\u2014", " - ")
            .replace("\u2013", " - ")
            .replace("...", " - ")
            .replace("\u2026", " - ")
            .replace("--", " - ");
    for (String written : BLANKS.split(clean.strip())) {
      take(written, words);
    }
    return words;
  }

  private void take(String written, List<String> words) {
    String word = BEGINNINGS.matcher(cut(written)).replaceFirst("").toLowerCase(Locale.ROOT);
    word = ENDS.matcher(word).replaceFirst("");
    boolean comma = word.endsWith(",");
    word = word.replaceFirst(",+$", "");
    word = ENDS.matcher(word).replaceFirst("");
    boolean cutOff = word.length() > 1 && word.endsWith(CUT_OFF);
    word = cutOff ? word.substring(0, word.length() - 1) : word;
    if (!word.isEmpty()) {
      spelled(word, words);
    }
    if (comma) {
      words.add(BREATH);
    }
    if (cutOff) {
      words.add(CUT_OFF);
    }
  }

  private static String cut(String written) {
    if (written.length() <= LONGEST_WORD) {
      return written;
    }
    boolean isWithinASign = Character.isHighSurrogate(written.charAt(LONGEST_WORD - 1));
    return written.substring(0, isWithinASign ? LONGEST_WORD - 1 : LONGEST_WORD);
  }

  /** A word in two parts, of which one is the rest. */
  private void spelled(String meant, String rest, List<String> words) {
    for (String part : meant.split(" ")) {
      if (part.contains(REST)) {
        spelled(part.replace(REST, rest), words);
      } else {
        words.add(part);
      }
    }
  }

  private void spelled(String word, List<String> words) {
    String other = spellings.get(word);
    if (other != null) {
      words.addAll(List.of(other.split(" ")));
      return;
    }
    for (Map.Entry<String, String> ending : endings.entrySet()) {
      String beginning = word.substring(0, Math.max(0, word.length() - ending.getKey().length()));
      if (word.endsWith(ending.getKey()) && !beginning.isEmpty()) {
        spelled(ending.getValue(), beginning, words);
        return;
      }
    }
    for (Map.Entry<String, String> beginning : beginnings.entrySet()) {
      if (word.startsWith(beginning.getKey()) && word.length() > beginning.getKey().length()) {
        spelled(beginning.getValue(), word.substring(beginning.getKey().length()), words);
        return;
      }
    }
    for (String part : NUMBER_AND_UNIT.split(word)) {
      String known = spellings.getOrDefault(part, part);
      words.addAll(List.of(known.split(" ")));
    }
  }
}
