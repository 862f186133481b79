package org.maestro.planning.pddl;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.maestro.planning.ground.Atom;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Schema;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Word;

/**
 * Reads a domain and a problem: ADL, which is STRIPS with types, conditions of any kind, equality
 * and conditional effects; action costs; and functions that are only increased and decreased by
 * constant amounts.
 */
public final class PddlReader {
  private static final Set<String> REQUIREMENTS =
      Set.of(
          ":strips",
          ":adl",
          ":typing",
          ":negative-preconditions",
          ":equality",
          ":action-costs",
          ":existential-preconditions",
          ":universal-preconditions",
          ":quantified-preconditions",
          ":disjunctive-preconditions",
          ":conditional-effects",
          ":fluents",
          ":numeric-fluents");

  private static final int MOST_GOALS = 4_096;

  private final Symbols symbols = new Symbols();
  private final List<Group> actions = new ArrayList<>();
  private String domainName = "";

  private PddlReader() {}

  /**
   * Reads both files, which may be compressed with gzip.
   *
   * @throws IOException when a file cannot be read; says which, and why
   * @throws PddlException when its text is not understood
   */
  public static LiftedTask read(Path domain, Path problem) throws IOException {
    return parse(domain.toString(), text(domain), problem.toString(), text(problem));
  }

  /**
   * Reads both texts.
   *
   * @param domainSource what errors call the domain's text
   * @param problemSource what errors call the problem's text
   * @throws PddlException when a text is not understood
   */
  public static LiftedTask parse(
      String domainSource, String domain, String problemSource, String problem) {
    PddlReader reader = new PddlReader();
    reader.domain(ExpressionReader.read(domainSource, domain));
    return reader.problem(ExpressionReader.read(problemSource, problem));
  }

  private static String text(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new IOException(file + " is a directory; name a PDDL file in it.");
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      in.mark(2);
      boolean compressed = in.read() == 0x1f && in.read() == 0x8b;
      in.reset();
      InputStream plain = compressed ? new GZIPInputStream(in) : in;
      return new String(plain.readAllBytes(), StandardCharsets.UTF_8);
    } catch (ZipException | EOFException e) {
      throw new IOException(
          file + " begins as a gzip file, but cannot be unpacked: it is cut off or broken.", e);
    }
  }

  private void domain(Group text) {
    domainName = name(text, "domain");
    List<Group> sections = sections(text);
    for (Group section : sections) {
      switch (section.head()) {
        case ":requirements" -> checkRequirements(section);
        case ":types" -> symbols.addTypes(section.rest());
        case ":constants", ":predicates", ":functions" -> {}
        case ":action" -> actions.add(section);
        default -> throw unsupported(section);
      }
    }
    for (Group section : sections) {
      switch (section.head()) {
        case ":constants" -> symbols.addObjects(section.rest());
        case ":predicates" ->
            section.rest().forEach(item -> symbols.addPredicate(item.group("a predicate")));
        case ":functions" -> addFunctions(section);
        default -> {}
      }
    }
  }

  private static PddlException unsupported(Group section) {
    return section
        .position()
        .error(
            section.head().isEmpty()
                ? "Expected a section such as (:action ...)."
                : "(" + section.head() + " ...) is not supported.");
  }

  private static void checkRequirements(Group section) {
    for (Expression item : section.rest()) {
      Word requirement = item.word("a requirement");
      if (!REQUIREMENTS.contains(requirement.text())) {
        throw requirement
            .position()
            .error("The requirement %s is not supported.".formatted(requirement.text()));
      }
    }
  }

  private void addFunctions(Group section) {
    List<Expression> items = section.rest();
    for (int i = 0; i < items.size(); i++) {
      if (items.get(i) instanceof Word word && word.text().equals("-")) {
        Word type = ++i < items.size() ? items.get(i).word("number") : word;
        if (!type.text().equals("number")) {
          throw type.position()
              .error("Functions have to be numbers, found %s.".formatted(type.text()));
        }
      } else {
        symbols.addFunction(items.get(i).group("a function"));
      }
    }
  }

  private LiftedTask problem(Group text) {
    name(text, "problem");
    List<Group> sections = sections(text);
    if (sections.stream().noneMatch(section -> section.head().equals(":domain"))) {
      throw text.position()
          .error("The problem does not name its (:domain %s).".formatted(domainName));
    }
    refuseTwo(":goal", sections);
    refuseTwo(":metric", sections);
    Map<Integer, BigDecimal> metric = Map.of();
    for (Group section : sections) {
      switch (section.head()) {
        case ":domain" -> checkDomain(section);
        case ":requirements" -> checkRequirements(section);
        case ":objects" -> symbols.addObjects(section.rest());
        case ":metric" -> metric = metric(section);
        case ":init", ":goal" -> {}
        default -> throw unsupported(section);
      }
    }
    refuseActionsOfOneName();
    InitialFacts facts = new InitialFacts(symbols, facts(sections), effects());
    List<Schema> schemas =
        actions.stream().flatMap(action -> schemas(action, facts).stream()).toList();
    List<Atom> initial = new ArrayList<>();
    Map<Atom, BigDecimal> values = new LinkedHashMap<>();
    List<Schema> goals = List.of();
    for (Group section : sections) {
      if (section.head().equals(":init")) {
        section.rest().forEach(item -> addInitial(item, initial, values));
      } else if (section.head().equals(":goal")) {
        if (section.items().size() != 2) {
          throw section.position().error("Expected one condition in (:goal ...).");
        }
        goals = goals(section, facts);
      }
    }
    if (goals.isEmpty()) {
      throw text.position().error("The problem has no (:goal ...).");
    }
    return new LiftedTask(
        symbols.objectNames(),
        List.copyOf(symbols.predicates.keySet()),
        List.copyOf(symbols.functions.keySet()),
        schemas,
        initial,
        values,
        goals,
        metric);
  }

  private static void refuseTwo(String head, List<Group> sections) {
    List<Group> such = sections.stream().filter(part -> part.head().equals(head)).toList();
    if (such.size() > 1) {
      throw such.get(1).position().error("(%s ...) is there twice.".formatted(head));
    }
  }

  private void checkDomain(Group section) {
    Word name =
        section.items().size() == 2
            ? section.items().get(1).word("the domain's name")
            : new Word(section.position(), "");
    if (!name.text().equals(domainName)) {
      throw name.position()
          .error("The problem is of the domain %s, not of %s.".formatted(name.text(), domainName));
    }
  }

  /** A plan names its actions: which of two is meant nobody could tell. */
  private void refuseActionsOfOneName() {
    Set<String> names = new HashSet<>();
    for (Group section : actions) {
      if (section.items().size() > 1
          && section.items().get(1) instanceof Word name
          && !names.add(name.text())) {
        throw name.position().error("The action %s is there twice.".formatted(name.text()));
      }
    }
  }

  private static List<Expression> facts(List<Group> sections) {
    return sections.stream()
        .filter(section -> section.head().equals(":init"))
        .flatMap(section -> section.rest().stream())
        .toList();
  }

  private List<Expression> effects() {
    return actions.stream()
        .flatMap(action -> Optional.ofNullable(parts(action).get(":effect")).stream())
        .toList();
  }

  /** What stands behind each of an action's keywords. */
  private static Map<String, Expression> parts(Group section) {
    if (section.items().size() < 2) {
      throw section.position().error("Expected an action's name.");
    }
    if (section.items().get(1) instanceof Word name && name.text().startsWith(":")) {
      throw name.position().error("Expected an action's name, found %s.".formatted(name.text()));
    }
    Map<String, Expression> parts = new LinkedHashMap<>();
    for (int i = 2; i < section.items().size(); i += 2) {
      Word key = section.items().get(i).word("a part such as :effect");
      if (!Set.of(":parameters", ":precondition", ":effect").contains(key.text())) {
        throw key.position().error("%s is not supported in an action.".formatted(key.text()));
      }
      if (i + 1 == section.items().size()) {
        throw key.position().error("Expected something after %s.".formatted(key.text()));
      }
      if (parts.put(key.text(), section.items().get(i + 1)) != null) {
        throw key.position().error("%s is there twice.".formatted(key.text()));
      }
    }
    return parts;
  }

  private List<Schema> schemas(Group section, InitialFacts facts) {
    Map<String, Expression> parts = parts(section);
    Word name = section.items().get(1).word("an action's name");
    Group nothing = new Group(name.position(), List.of());
    Optional<Group> parameters =
        Optional.ofNullable(parts.get(":parameters"))
            .map(list -> list.group("a list of parameters"));
    Expression condition = parts.getOrDefault(":precondition", nothing);
    Expression effect = parts.getOrDefault(":effect", nothing);
    SchemaReader check = new SchemaReader(symbols, name.text(), name.position());
    parameters.ifPresent(check::parameters);
    check.checkCondition(condition);
    check.checkEffect(effect);
    return new PlainActions(
            symbols, facts, name.text(), name.position(), parameters, condition, effect)
        .all();
  }

  /** One for each way in which it can be reached. */
  private List<Schema> goals(Group section, InitialFacts facts) {
    Expression goal = section.items().get(1);
    new SchemaReader(symbols, "goal", section.position()).checkCondition(goal);
    Alternatives alternatives = new Alternatives(symbols, facts, MOST_GOALS);
    List<Alternatives.Alternative> ways = alternatives.of(goal, true, Map.of());
    if (alternatives.isExceeded()) {
      throw section
          .position()
          .error("The goal can be reached in more than %d ways.".formatted(MOST_GOALS));
    }
    List<Schema> goals = new ArrayList<>();
    for (Alternatives.Alternative way : ways) {
      SchemaReader reader = new SchemaReader(symbols, "goal", section.position());
      reader.addParameters(way.variables());
      way.literals().values().forEach(reader::condition);
      goals.add(reader.done());
    }
    if (goals.isEmpty()) {
      SchemaReader never = new SchemaReader(symbols, "goal", section.position());
      never.refuse();
      goals.add(never.done());
    }
    return goals;
  }

  private void addInitial(Expression item, List<Atom> initial, Map<Atom, BigDecimal> values) {
    Group group = item.group("a fact");
    SchemaReader reader = new SchemaReader(symbols, "init", item.position());
    switch (group.head()) {
      case "=" -> {
        if (group.items().size() != 3) {
          throw group.position().error("Expected (= function number).");
        }
        Word number = group.items().get(2).word("a number");
        if (!SchemaReader.isNumber(number.text())) {
          throw number.position().error("Expected a number, found %s.".formatted(number.text()));
        }
        BigDecimal value = new BigDecimal(number.text());
        BigDecimal before = values.put(reader.groundFunction(group.items().get(1)), value);
        if (before != null && before.compareTo(value) != 0) {
          throw group
              .position()
              .error("This function has the value %s already.".formatted(before.toPlainString()));
        }
      }
      case "at" -> {
        boolean timed =
            !symbols.predicates.containsKey("at")
                || group.items().size() == 3 && group.items().get(2) instanceof Group;
        if (timed) {
          throw group.position().error("Timed facts are not supported.");
        }
        initial.add(reader.fact(group));
      }
      case "not" -> {
        // What is not said to hold does not hold.
      }
      case "" -> throw group.position().error("Expected a fact.");
      default -> initial.add(reader.fact(group));
    }
  }

  private Map<Integer, BigDecimal> metric(Group section) {
    if (section.items().size() != 3) {
      throw section.position().error("Expected (:metric minimize (function)).");
    }
    Word direction = section.items().get(1).word("minimize");
    if (!direction.text().equals("minimize")) {
      throw direction
          .position()
          .error("Only minimize is supported, found %s.".formatted(direction.text()));
    }
    Map<Integer, BigDecimal> factors = new LinkedHashMap<>();
    addMetric(section.items().get(2), BigDecimal.ONE, factors);
    return factors;
  }

  private void addMetric(
      Expression expression, BigDecimal factor, Map<Integer, BigDecimal> factors) {
    if (expression instanceof Group group && group.head().equals("+")) {
      group.rest().forEach(item -> addMetric(item, factor, factors));
    } else if (expression instanceof Group group
        && group.head().equals("*")
        && group.items().size() == 3
        && group.rest().stream().anyMatch(PddlReader::isNumber)) {
      int number = isNumber(group.items().get(1)) ? 1 : 2;
      Word times = (Word) group.items().get(number);
      addMetric(
          group.items().get(3 - number), factor.multiply(new BigDecimal(times.text())), factors);
    } else {
      Atom function =
          new SchemaReader(symbols, "metric", expression.position()).groundFunction(expression);
      if (function.terms().length > 0) {
        throw expression.position().error("Functions of objects are not supported in a metric.");
      }
      factors.merge(function.symbol(), factor, BigDecimal::add);
    }
  }

  private static boolean isNumber(Expression expression) {
    return expression instanceof Word word && SchemaReader.isNumber(word.text());
  }

  private static String name(Group text, String kind) {
    if (text.head().equals("define")
        && text.items().size() > 1
        && text.items().get(1) instanceof Group group
        && group.head().equals(kind)
        && group.items().size() == 2) {
      return group.items().get(1).word("a name").text();
    }
    throw text.position().error("Expected (define (%s NAME) ...).".formatted(kind));
  }

  private static List<Group> sections(Group text) {
    return text.items().subList(2, text.items().size()).stream()
        .map(item -> item.group("a section such as (:init ...)"))
        .toList();
  }
}
