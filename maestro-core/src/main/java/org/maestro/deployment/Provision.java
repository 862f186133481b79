package org.maestro.deployment;

import java.util.Collection;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * The equipment that a host provides, or that an agent needs.
 *
 * @param amountByWord such as {@code memory} and 512; a word alone is any amount when it is
 *     provided, and none in particular when it is needed
 */
public record Provision(Map<String, Double> amountByWord) {
  private static final Pattern ONE =
      Pattern.compile("[A-Za-z][A-Za-z0-9-]*([ =][0-9]+([.][0-9]+)?)?");

  public Provision {
    amountByWord = Map.copyOf(amountByWord);
  }

  /**
   * @param items words, each alone or with a number behind a blank or an equals sign
   * @throws IllegalArgumentException that says which one cannot be read
   */
  public static Provision of(Collection<String> items) {
    Map<String, Double> amounts = new TreeMap<>();
    for (String item : items) {
      if (!ONE.matcher(item).matches()) {
        throw new IllegalArgumentException(
            "\"%s\" is nothing that a host provides; write a word, such as microphone, or a word and how much, such as \"memory 512\"."
                .formatted(item));
      }
      int blank = item.replace('=', ' ').indexOf(' ');
      amounts.put(
          blank < 0 ? item : item.substring(0, blank),
          blank < 0 ? Double.NaN : Double.parseDouble(item.substring(blank + 1)));
    }
    return new Provision(amounts);
  }

  /** What is needed and not provided here, in alphabetical order; empty when all is. */
  public SortedSet<String> lacks(Provision needed) {
    SortedSet<String> lacking = new TreeSet<>();
    needed.amountByWord.forEach(
        (word, amount) -> {
          Double here = amountByWord.get(word);
          if (here == null || here < amount) {
            lacking.add(
                amount.isNaN()
                    ? word
                    : word
                        + " "
                        + (amount == Math.rint(amount)
                            ? String.valueOf(Math.round(amount))
                            : amount));
          }
        });
    return lacking;
  }

  /** What is needed, in words. */
  public String inWords() {
    return String.join(" and ", new Provision(Map.of()).lacks(this));
  }
}
