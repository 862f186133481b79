package org.maestro.language.wording;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.ReportRule;
import org.maestro.ontology.home.Home;

/**
 * Reports that are written in another language, said in this one by the grammar's rules for them.
 * What no rule says is quoted as it was written, and told to be so. Immutable.
 */
final class TranslatedReports {
  /** The category of whole reports, and of reasons within them. */
  static final String REPORT = "Report";

  private static final Pattern PLACE = Pattern.compile("\\{(\\w+)}");
  private static final Pattern SENTENCE_END = Pattern.compile("\\. (?=\\S)");

  /** What is longer is others' text, and quoted. */
  private static final int LONGEST = 1_500;

  /** So often is a rule tried at most for one report; others' text may be anything. */
  private static final int MOST_TRIALS = 100_000;

  private final Phrases phrases;
  private final ReportedTerms terms;
  private final Function<String, Optional<String>> formulas;
  private final Map<String, List<ReportPattern>> patterns;

  /**
   * @param formulas what a text in MAESTRO-SL says; empty when it says nothing for which there are
   *     words
   */
  TranslatedReports(Home home, Grammar grammar, Function<String, Optional<String>> formulas) {
    this.phrases = new Phrases(grammar);
    this.terms = new ReportedTerms(home, grammar, formulas);
    this.formulas = formulas;
    this.patterns =
        grammar.reports().stream()
            .map(ReportPattern::new)
            .collect(
                Collectors.groupingBy(
                    ReportPattern::category, LinkedHashMap::new, Collectors.toList()));
  }

  /** A report of one or more sentences. */
  String of(String report) {
    Reported read = new Reading().report(report.strip());
    return read.text();
  }

  /** The reading of one report: what was read of its parts is not read again. */
  private final class Reading {
    private record Part(String category, String text) {}

    private final Map<Part, Optional<Reported>> known = new HashMap<>();
    private int trials;

    Reported report(String text) {
      return text.length() > LONGEST
          ? quoted(text)
          : read(REPORT, text).orElseGet(() -> quoted(text));
    }

    private Optional<Reported> read(String category, String written) {
      if (++trials > MOST_TRIALS) {
        return Optional.empty();
      }
      if (!patterns.containsKey(category)) {
        return terms.of(category, written);
      }
      String text = ReportPattern.withoutFullStop(written);
      Part part = new Part(category, text);
      Optional<Reported> before = known.get(part);
      if (before != null) {
        return before;
      }
      known.put(part, Optional.empty());
      Optional<Reported> read = byRules(category, text);
      if (category.equals(REPORT)) {
        read = Optional.of(best(text, read));
      }
      known.put(part, read);
      return read;
    }

    private Optional<Reported> byRules(String category, String text) {
      Optional<Reported> best = Optional.empty();
      for (ReportPattern pattern : patterns.getOrDefault(category, List.of())) {
        if (++trials > MOST_TRIALS) {
          return best;
        }
        Optional<Reported> read =
            pattern.in(text, this::read).flatMap(TranslatedReports.this::said);
        if (read.isPresent() && isBetter(read.get(), best)) {
          best = read;
        }
        if (best.isPresent() && best.get().foreign() == 0) {
          break;
        }
      }
      return best;
    }

    private boolean isBetter(Reported one, Optional<Reported> other) {
      return other.isEmpty() || one.foreign() < other.get().foreign();
    }

    /** As a whole, else sentence by sentence, else as it was written. */
    private Reported best(String text, Optional<Reported> whole) {
      Reported best = whole.orElseGet(() -> quoted(text));
      Matcher ends = SENTENCE_END.matcher(text);
      while (best.foreign() > 0 && trials <= MOST_TRIALS && ends.find()) {
        Reported first = report(text.substring(0, ends.start()));
        Reported rest = report(text.substring(ends.end()));
        if (first.foreign() + rest.foreign() < best.foreign()) {
          best =
              new Reported(
                  Phrases.sentence(first.text()) + " " + Phrases.capitalized(rest.text()),
                  "",
                  first.foreign() + rest.foreign());
        }
      }
      return best;
    }

    private Reported quoted(String text) {
      return new Reported(
          phrases.of("report-foreign", Map.of("text", text)), "", Math.max(1, text.length()));
    }
  }

  private Optional<Reported> said(ReportPattern.Found found) {
    ReportRule rule = found.rule();
    if (rule.formula()) {
      return formulas.apply(formula(rule.result(), found.values())).map(Reported::of);
    }
    Map<String, String> values = new HashMap<>();
    found.values().forEach((name, value) -> values.put(name, value.text()));
    return Optional.of(
        new Reported(
            ReportPattern.withoutFullStop(phrases.filled(rule.result(), values)),
            "",
            found.foreign()));
  }

  private static String formula(String form, Map<String, Reported> values) {
    return PLACE
        .matcher(form)
        .replaceAll(
            found ->
                Matcher.quoteReplacement(
                    Objects.requireNonNull(values.get(found.group(1))).symbol()));
  }
}
