package org.maestro.knowledge.calibration;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.stream.Collectors;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A knowledge base that learns from what is measured how much settings really give to numbers, such
 * as lamps to the light, and believes it instead of what is stated. Thread-safe.
 */
public final class CalibratedKnowledge extends ForwardingKnowledge {
  /** Who concludes what was learnt. */
  public static final Source SOURCE = new Source(Source.Kind.OBSERVED, "calibration");

  private static final String EQUATION = "(= ";
  private static final MathContext DIGITS = new MathContext(3);

  private final Lock learning = new ReentrantLock();
  private final Map<String, MeasuredByEach> measured = new LinkedHashMap<>();
  private Map<String, Double> told = Map.of();
  private SharedNumbers numbers;
  private Home home;

  /** There may be places of which what was learnt has not been told yet. */
  private boolean isMore;

  public CalibratedKnowledge(KnowledgeBase knowledge) {
    super(knowledge);
    this.home = knowledge.home();
    this.numbers = new SharedNumbers(home.vocabulary());
  }

  @Override
  public Change learn(FeatureRun run) {
    Change change = super.learn(run);
    learning.lock();
    try {
      take(home());
      if (!numbers.isEmpty()) {
        moved(run.member(), change);
        measured(run.member(), DirectMeasurements.of(run));
      }
    } finally {
      learning.unlock();
    }
    return change;
  }

  @Override
  public boolean doubt(List<String> conditions) {
    learning.lock();
    try {
      boolean any = !told.isEmpty() && conditions.stream().anyMatch(numbers::areIn);
      if (any) {
        measured.clear();
        believe(Map.of());
      }
      return any;
    } finally {
      learning.unlock();
    }
  }

  /**
   * What was learnt elsewhere, and is doubted because of these conditions.
   *
   * @param conditions in MAESTRO-SL
   * @return that none of it is known, {@code (unknown (gain lamp-b1 zone-b))}
   */
  public static List<String> doubtful(Home home, Snapshot known, List<String> conditions) {
    if (conditions.stream().noneMatch(new SharedNumbers(home.vocabulary())::areIn)) {
      return List.of();
    }
    return known.beliefs().stream()
        .filter(belief -> belief.source().agent().equals(SOURCE.agent()))
        .map(belief -> SlParser.fact(belief.fact()))
        .filter(Fact.Equation.class::isInstance)
        .map(fact -> ((Fact.Equation) fact).fluent())
        .map(share -> new Fact.Unknown(new Formula.Atom(share.name(), share.arguments())))
        .map(SlPrinter::print)
        .toList();
  }

  /** What is stated of devices that are new, or described otherwise, is looked up anew. */
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private void take(Home now) {
    if (now == home) {
      return;
    }
    Home before = home;
    home = now;
    isMore = !told.isEmpty();
    boolean isSame =
        before.vocabulary().equals(now.vocabulary()) && before.devices().equals(now.devices());
    if (!isSame) {
      measured.clear();
      believe(Map.of());
      numbers = new SharedNumbers(now.vocabulary());
    }
  }

  /** A step that has no share in a number was to change it. */
  private void moved(String member, Change change) {
    Term mover = new Term.Name(member);
    for (String fact : change.expected()) {
      int end = fact.lastIndexOf(' ');
      MeasuredByEach number =
          fact.startsWith(EQUATION) ? measured.get(fact.substring(EQUATION.length(), end)) : null;
      if (number != null
          && number.parts().stream().noneMatch(p -> p.share().arguments().contains(mover))) {
        number.disturbed();
      }
    }
  }

  private void measured(String observer, Map<Expression.Fluent, Double> values) {
    Snapshot now = snapshot();
    boolean any = isMore;
    for (Map.Entry<Expression.Fluent, Double> one : values.entrySet()) {
      Expression.Fluent number = one.getKey();
      if (numbers.has(number) && isBelieved(number, one.getValue(), now)) {
        MeasuredByEach shares =
            measured.computeIfAbsent(
                SlPrinter.print(number), name -> new MeasuredByEach(numbers.parts(number, now)));
        Map<Part, Double> before = Map.copyOf(shares.otherwise());
        shares.measured(observer, one.getValue(), now);
        any |= !before.equals(shares.otherwise());
      }
    }
    if (any) {
      isMore = false;
      believe(otherwise(now));
    }
  }

  /** What is measured for somewhere else is reckoned there, and another may be believed more. */
  private static boolean isBelieved(Expression.Fluent number, double value, Snapshot now) {
    return now.number(number).orElse(Double.NaN) == value;
  }

  private void believe(Map<String, Double> shares) {
    if (!shares.equals(told)) {
      told = shares;
      Map<String, Double> surely = new TreeMap<>();
      shares.forEach((share, value) -> surely.put(EQUATION + share + " " + value + ")", 1.0));
      believe(SOURCE, surely);
    }
  }

  /** What is otherwise than stated, where it was measured and where it was not. */
  private Map<String, Double> otherwise(Snapshot now) {
    Map<Part, Double> learnt = new LinkedHashMap<>();
    measured.values().forEach(number -> learnt.putAll(number.otherwise()));
    Map<String, Double> shares = new TreeMap<>();
    learnt.forEach((part, share) -> shares.put(SlPrinter.print(part.share()), rounded(share)));
    learnt.keySet().stream()
        .collect(Collectors.groupingBy(part -> List.of(part.share().name(), part.setting())))
        .values()
        .forEach(parts -> shares.putAll(elsewhere(parts, learnt, now)));
    return shares;
  }

  /** Where nothing is measured, what is set gives the same part of what is stated. */
  private Map<String, Double> elsewhere(List<Part> parts, Map<Part, Double> learnt, Snapshot now) {
    double stated = parts.stream().mapToDouble(Part::stated).sum();
    double found = parts.stream().mapToDouble(learnt::get).sum();
    Map<String, Double> shares = new TreeMap<>();
    for (Part other : numbers.elsewhere(parts.get(0), now)) {
      if (!measured.containsKey(SlPrinter.print(numbers.number(other.share())))) {
        shares.put(SlPrinter.print(other.share()), rounded(other.stated() * found / stated));
      }
    }
    return shares;
  }

  /**
   * What the setting takes away it is not believed to take; three digits are more than is known.
   */
  private static double rounded(double share) {
    return new BigDecimal(Math.max(0, share)).round(DIGITS).doubleValue();
  }
}
