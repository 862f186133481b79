package org.maestro.launch;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.language.Language;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;
import org.maestro.language.reference.Situation;

/** Which rules of grammars some utterances use: who writes a grammar sees what none has tried. */
final class UsedRules {
  private final Map<String, Grammar> grammars = new TreeMap<>();
  private final Map<String, Set<Integer>> used = new TreeMap<>();

  void note(Language language, String utterance, Situation situation) {
    String tag = language.grammar().language();
    grammars.put(tag, language.grammar());
    used.computeIfAbsent(tag, t -> new TreeSet<>()).addAll(language.rulesOf(utterance, situation));
  }

  void print(PrintWriter out) {
    grammars.forEach(
        (tag, grammar) -> {
          Map<Integer, Rule> rules = byLine(grammar);
          Set<Integer> lines = used.getOrDefault(tag, Set.of());
          out.printf(
              "%d of %d rules of the grammar %s are used by these utterances (%d %%)%n",
              lines.size(), rules.size(), tag, Math.round(100.0 * lines.size() / rules.size()));
          rules.forEach(
              (line, rule) -> {
                if (!lines.contains(line)) {
                  out.printf("  unused, line %d: %s%n", line, inWords(rule));
                }
              });
        });
  }

  private static Map<Integer, Rule> byLine(Grammar grammar) {
    Map<Integer, Rule> rules = new TreeMap<>();
    grammar.rules().forEach(rule -> rules.putIfAbsent(rule.line(), rule));
    return rules;
  }

  private static String inWords(Rule rule) {
    List<Symbol> symbols = rule.symbols();
    return rule.category()
        + " = "
        + symbols.stream()
            .map(
                symbol ->
                    symbol instanceof Symbol.Word word
                        ? word.text()
                        : ((Symbol.Category) symbol).name())
            .collect(Collectors.joining(" "));
  }
}
