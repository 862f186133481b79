package org.maestro.knowledge.habits;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.knowledge.Instances;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Counts habits (ADE, 4.1; A57): how often a condition has become so within two hours of the time
 * of day that it is now, on days like today. What makes it so again within two hours is the same
 * event. Confined to one thread but for {@link #concerns}.
 */
public final class Habits {
  private static final Logger LOG = LoggerFactory.getLogger(Habits.class);
  private static final Source SOURCE = new Source(Source.Kind.OBSERVED, "habits");
  private static final Duration ABOUT = Duration.ofHours(2);
  private static final Duration REMEMBERED = Duration.ofDays(60);

  /** As often the numbers are made those of the time of day that it is. */
  public static final Duration BETWEEN_REVIEWS = Duration.ofMinutes(10);

  private final KnowledgeBase knowledge;
  private final Clock clock;
  private final HabitLog log;
  private final List<Happening> happenings = new ArrayList<>();
  private final Set<Expression.Fluent> so = new HashSet<>();
  private final Map<Expression.Fluent, Integer> told = new LinkedHashMap<>();
  private final CountedFluents counted;

  public Habits(KnowledgeBase knowledge, Clock clock, HabitLog log) {
    this.knowledge = knowledge;
    this.clock = clock;
    this.log = log;
    this.counted = new CountedFluents(knowledge);
  }

  /** Takes up what was counted before; to be called once, before anything else. */
  public void begin() {
    Instant oldest = clock.instant().minus(REMEMBERED);
    int number = 0;
    for (String line : log.lines()) {
      number++;
      try {
        Happening happening = read(line);
        if (happening.at().isAfter(oldest)) {
          happenings.add(happening);
        }
      } catch (SlSyntaxException | DateTimeParseException | ClassCastException e) {
        LOG.warn("Line {} of the habits is passed over, as it cannot be read.", number);
      }
    }
    tell();
  }

  private static Happening read(String line) {
    int blank = line.indexOf(' ');
    Instant at = Instant.parse(blank < 0 ? line : line.substring(0, blank));
    return new Happening(at, (Expression.Fluent) SlParser.expression(line.substring(blank + 1)));
  }

  /** Whether the change may have made something so that is counted. Any thread may ask. */
  public boolean concerns(KnowledgeBase.Change change) {
    return counted.speakOf(change.facts());
  }

  /** Whether the home has anything that is counted. Any thread may ask. */
  public boolean areAny() {
    return !counted.all().isEmpty();
  }

  /** Looks at what is so now, and counts what has become so. */
  public void look() {
    Set<Expression.Fluent> holding = new HashSet<>();
    counted.all().forEach(fluent -> holding.addAll(holding(fluent)));
    Instant now = clock.instant();
    for (Expression.Fluent one : holding) {
      if (!so.contains(one) && !isSameEvent(one, now)) {
        happenings.add(new Happening(now, one));
        log.add(now + " " + SlPrinter.print(one));
      }
    }
    so.clear();
    so.addAll(holding);
    tell();
  }

  private boolean isSameEvent(Expression.Fluent one, Instant now) {
    return happenings.stream()
        .anyMatch(before -> before.counted().equals(one) && before.at().plus(ABOUT).isAfter(now));
  }

  private List<Expression.Fluent> holding(PredicateDeclaration fluent) {
    List<Formula> conditions = new ArrayList<>();
    List<Term> variables = new ArrayList<>();
    fluent
        .parameters()
        .forEach(
            parameter -> {
              Term variable = new Term.Variable(parameter.name());
              variables.add(variable);
              parameter
                  .className()
                  .ifPresent(name -> conditions.add(new Formula.Atom(name, List.of(variable))));
            });
    fluent.countedWhen().ifPresent(conditions::add);
    Expression.Fluent number = new Expression.Fluent(fluent.name(), variables);
    return new Instances(new Formula.And(conditions), knowledge.snapshot())
        .all().values().stream().map(instance -> instance.apply(number)).toList();
  }

  /** Makes the numbers those of the time of day that it is now. */
  public void tell() {
    ZonedDateTime now = clock.instant().atZone(zone());
    Map<Expression.Fluent, Integer> numbers = new LinkedHashMap<>();
    told.keySet().forEach(number -> numbers.put(number, 0));
    for (Happening happening : happenings) {
      boolean counts = LikeNow.are(happening.at().atZone(zone()), now, ABOUT);
      numbers.merge(happening.counted(), counts ? 1 : 0, Integer::sum);
    }
    List<String> changed =
        numbers.entrySet().stream()
            .filter(number -> !number.getValue().equals(told.get(number.getKey())))
            .map(
                number ->
                    "(= %s %d)".formatted(SlPrinter.print(number.getKey()), number.getValue()))
            .toList();
    told.putAll(numbers);
    if (!changed.isEmpty()) {
      knowledge.state(SOURCE, changed);
    }
  }

  private ZoneId zone() {
    return knowledge.home().timeZone().orElseGet(ZoneId::systemDefault);
  }
}
