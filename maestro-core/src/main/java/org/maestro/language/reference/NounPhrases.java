package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Point;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Finds out what noun phrases refer to, in one situation. A definite one is the only candidate, or
 * the only one here, or the one spoken of last; else it is open. Not safe for threads.
 */
public final class NounPhrases {
  private final Situation situation;
  private final Relations relations;
  private final Candidates candidates;
  private final Surroundings surroundings;
  private final Choosing choosing;
  private final Descriptions descriptions;
  private final Set<Term.Name> mentioned = new LinkedHashSet<>();
  private final Set<String> kinds = new LinkedHashSet<>();
  private final List<Term.Name> group = new ArrayList<>();

  /** The class of those who are asked for as persons. */
  private static final String PERSON = "Person";

  /** The class of which everything is: who names it tells nothing. */
  public static final String THING = "Thing";

  private final Map<Form, Map<String, Reference>> resolved = new HashMap<>();
  private int variables;
  private int supposed;

  public NounPhrases(Situation situation) {
    this.situation = situation;
    this.relations = new Relations(situation);
    this.candidates = new Candidates(situation, relations);
    this.surroundings = new Surroundings(situation, relations);
    this.choosing = new Choosing(situation, relations, surroundings);
    this.descriptions = new Descriptions(situation, relations, this);
  }

  private NounPhrases(NounPhrases others) {
    this.situation = others.situation;
    this.relations = others.relations;
    this.candidates = others.candidates;
    this.surroundings = others.surroundings;
    this.choosing = others.choosing;
    this.descriptions = new Descriptions(situation, relations, this);
  }

  /** Those of another reading in the same situation: what was looked up is not looked up again. */
  public NounPhrases afresh() {
    return new NounPhrases(this);
  }

  public Relations relations() {
    return relations;
  }

  /** The things that phrases referred to so far, the latest last. */
  public List<Term.Name> mentioned() {
    return List.copyOf(mentioned);
  }

  /** Several things that were referred to together last. */
  public List<Term.Name> group() {
    return List.copyOf(group);
  }

  /** How many phrases refer to what is only supposed to be so, as nobody knows otherwise. */
  public int supposed() {
    return supposed;
  }

  /** The kinds of things that were spoken of. */
  public List<String> kinds() {
    return List.copyOf(kinds);
  }

  /**
   * What the phrase refers to.
   *
   * @param className of what is wanted; "" for any
   */
  public Reference resolve(Form phrase, String className) {
    if (phrase.is("it") || phrase.is("them") || phrase.is("him")) {
      return found(phrase, className);
    }
    Map<String, Reference> known = resolved.computeIfAbsent(phrase, p -> new HashMap<>());
    Reference before = known.get(className);
    if (before != null) {
      return before;
    }
    Reference found = found(phrase, className);
    known.put(className, found);
    return found;
  }

  private Reference found(Form phrase, String className) {
    return switch (phrase.head()) {
      case "np" ->
          isOfSeveralPlaces(phrase) ? inEach(phrase, className) : counted(phrase, className);
      case "and" -> joined(phrase, className);
      case "or" -> either(phrase, className);
      case "except" -> without(phrase, className);
      case "placed" -> resolve(placed(phrase.part(0), phrase.part(1)), className);
      case "somebody" -> somebody(phrase, className);
      case "everybody" -> everybody(phrase, className);
      case "it" -> latest(phrase, className);
      case "them" -> latestGroup(phrase, className);
      case "him" -> latest(phrase, className);
      case "speaker" -> person(situation.speaker(), phrase, className);
      case "self" -> person(situation.self(), phrase, className);
      case "everything" -> everything(phrase, className);
      case "point" -> point(phrase, className);
      case "_" -> new Reference.Unsaid();
      default -> new Reference.None(phrase);
    };
  }

  /** Coordinates, metres; on the floor unless a height is said. */
  private Reference point(Form phrase, String className) {
    double height = phrase.parts().size() > 2 ? Double.parseDouble(phrase.text(2)) : 0;
    Point point =
        new Point(Double.parseDouble(phrase.text(0)), Double.parseDouble(phrase.text(1)), height);
    return className.isEmpty()
            || situation.home().vocabulary().mayBeBoth(NamedPoints.CLASS, className)
        ? new Reference.Single(new Term.Name(point.name()))
        : new Reference.Mistyped(phrase);
  }

  /** The phrase with a place that was said after it. */
  public static Form placed(Form phrase, Form where) {
    if (phrase.is("np")) {
      List<Form> parts = new ArrayList<>(phrase.parts());
      int last = parts.size() - 1;
      parts.set(last, Form.of("at", parts.get(last), where));
      return new Form("np", parts);
    }
    if (phrase.is("except")) {
      return Form.of("except", placed(phrase.part(0), where), phrase.part(1));
    }
    return phrase.is("everything") ? Form.of("everything", where) : phrase;
  }

  /** What a place is named by. */
  public static Form place(Form where) {
    return where.is("rel") ? where.part(1) : where.part(0);
  }

  private static boolean isOfSeveralPlaces(Form phrase) {
    Form where = phrase.part(1).part(1);
    return phrase.text(0).equals("the")
        && phrase.part(1).is("at")
        && (where.is("each") || where.is("everywhere"));
  }

  /** The light in the kitchen and the hall is two, and the light everywhere is all. */
  private Reference inEach(Form phrase, String className) {
    Form nominal = phrase.part(1);
    if (nominal.part(1).is("everywhere")) {
      return counted(Form.of("np", Form.leaf("all"), nominal), className);
    }
    List<Form> all =
        nominal.part(1).parts().stream()
            .map(where -> Form.of("np", phrase.part(0), Form.of("at", nominal.part(0), where)))
            .toList();
    return resolve(new Form("and", all), className);
  }

  private Reference somebody(Form phrase, String className) {
    return persons(situation.home())
        .filter(
            kind -> className.isEmpty() || situation.home().vocabulary().mayBeBoth(kind, className))
        .<Reference>map(
            kind -> quantified(Description.ofClass(kind), className, Reference.Any::new))
        .orElseGet(() -> new Reference.Mistyped(phrase));
  }

  /** All but who speaks, or those who are there. */
  private Reference everybody(Form phrase, String className) {
    if (!phrase.parts().isEmpty()) {
      return persons(situation.home())
          .map(
              kind ->
                  resolve(
                      Form.of(
                          "np",
                          Form.leaf("every"),
                          Form.of("at", Form.of("noun", Form.leaf(kind)), phrase.part(0))),
                      className))
          .orElseGet(() -> new Reference.Mistyped(phrase));
    }
    List<Term.Name> all =
        persons(situation.home()).stream()
            .flatMap(kind -> situation.facts().individuals(kind).stream())
            .filter(name -> situation.speaker().filter(name.text()::equals).isEmpty())
            .filter(name -> relations.isA(name, className))
            .toList();
    return all.isEmpty() ? new Reference.None(phrase) : together(all);
  }

  /** The class of those who are asked for as persons. */
  public static Optional<String> persons(Home home) {
    return Optional.of(PERSON).filter(home.vocabulary().classes()::containsKey);
  }

  private Reference person(Optional<String> who, Form phrase, String className) {
    return who.<Term.Name>map(Term.Name::new)
        .map(
            name ->
                relations.isA(name, className)
                    ? single(name)
                    : (Reference) new Reference.Mistyped(phrase))
        .orElse(new Reference.None(phrase));
  }

  /** A thing that was meant without being named. */
  public Reference spokenOf(Term term) {
    return term instanceof Term.Name name ? single(name) : new Reference.Single(term);
  }

  private Reference single(Term.Name name) {
    mentioned.remove(name);
    mentioned.add(name);
    return new Reference.Single(name);
  }

  private Reference latest(Form phrase, String className) {
    List<Term.Name> spoken = new ArrayList<>(mentioned);
    Collections.reverse(spoken);
    spoken.addAll(situation.discourse().things());
    return spoken.stream()
        .filter(name -> relations.isA(name, className))
        .filter(name -> situation.speaker().filter(name.text()::equals).isEmpty())
        .findFirst()
        .map(this::single)
        .orElse(new Reference.None(phrase));
  }

  private Reference latestGroup(Form phrase, String className) {
    List<Term.Name> together = group.isEmpty() ? situation.discourse().group() : group;
    List<Term.Name> fitting =
        together.stream().filter(name -> relations.isA(name, className)).toList();
    return fitting.isEmpty() ? latest(phrase, className) : several(fitting);
  }

  /** The place spoken of last. */
  public Optional<Term> lastPlace() {
    List<Term.Name> spoken = new ArrayList<>(mentioned);
    Collections.reverse(spoken);
    spoken.addAll(situation.discourse().things());
    return spoken.stream()
        .filter(
            name ->
                relations.ofPlaces().stream()
                    .anyMatch(predicate -> relations.fits(predicate, 1, name)))
        .<Term>map(name -> name)
        .findFirst();
  }

  /**
   * The one of the class that was spoken of last, or is the only one here or anywhere, or of
   * several the only one of which enough is known.
   */
  public Reference only(String className, Predicate<Term> known) {
    Reference last = latest(Form.leaf("it"), className);
    if (last instanceof Reference.Single) {
      return last;
    }
    List<Term.Name> all = candidates(Description.ofClass(className), className);
    List<Term.Name> here = all.stream().filter(this::isHere).toList();
    List<Term.Name> among = here.isEmpty() ? all : here;
    List<Term.Name> fitting = among.size() == 1 ? among : among.stream().filter(known).toList();
    if (fitting.size() == 1) {
      return single(fitting.get(0));
    }
    Form kind = Form.of("np", Form.leaf("the"), Form.of("noun", Form.leaf(className)));
    return among.isEmpty() ? new Reference.None(kind) : new Reference.Open(kind, among);
  }

  private Reference joined(Form phrase, String className) {
    List<Term> all = new ArrayList<>();
    for (Form part : phrase.parts()) {
      Reference one = resolve(part, className);
      if (one instanceof Reference.Single single) {
        all.add(single.term());
      } else if (one instanceof Reference.Several several) {
        all.addAll(several.terms());
      } else {
        return one;
      }
    }
    return new Reference.Several(all.stream().distinct().toList());
  }

  private Reference either(Form phrase, String className) {
    List<Reference> options = new ArrayList<>();
    for (Form part : phrase.parts()) {
      Reference one = resolve(part, className);
      boolean isOne = one instanceof Reference.Single || one instanceof Reference.Any;
      if (one instanceof Reference.Either more) {
        options.addAll(more.options());
      } else if (isOne) {
        options.add(one);
      } else {
        return one;
      }
    }
    return new Reference.Either(phrase, options);
  }

  private Reference without(Form phrase, String className) {
    Form whole = phrase.part(0);
    Reference all = resolve(whole, className);
    Reference but = excepted(phrase.part(1), className);
    List<Term> excluded = terms(but);
    if (excluded.isEmpty()) {
      return but;
    }
    if (isUnbounded(whole) && excluded.stream().noneMatch(terms(all)::contains)) {
      // What is left out shows that not only what is here is meant.
      all = resolve(placed(whole, Form.leaf("everywhere")), className);
    }
    if (all instanceof Reference.All every) {
      List<Formula> conditions = new ArrayList<>(every.conditions());
      excluded.forEach(
          term ->
              conditions.add(
                  new Formula.Not(
                      new Formula.Comparison(
                          Formula.Relation.EQUAL,
                          new Expression.OfTerm(new Term.Variable(every.variable().name())),
                          new Expression.OfTerm(term)))));
      return new Reference.All(every.variable(), conditions);
    }
    List<Term> left = terms(all).stream().filter(term -> !excluded.contains(term)).toList();
    return left.isEmpty() ? new Reference.None(phrase) : several(left);
  }

  /** A thing, or all that is in a place. */
  private Reference excepted(Form phrase, String className) {
    Reference but = resolve(phrase, className);
    return but instanceof Reference.Mistyped
            && resolve(phrase, "") instanceof Reference.Single place
            && !relations.within(place.term(), className).isEmpty()
        ? several(relations.within(place.term(), className))
        : but;
  }

  /** Whether no place was said. */
  private static boolean isUnbounded(Form phrase) {
    return phrase.is("np") && !phrase.part(phrase.parts().size() - 1).is("at");
  }

  private static List<Term> terms(Reference reference) {
    if (reference instanceof Reference.Single single) {
      return List.of(single.term());
    }
    return reference instanceof Reference.Several several ? several.terms() : List.of();
  }

  private static Reference several(List<? extends Term> terms) {
    return terms.size() == 1
        ? new Reference.Single(terms.get(0))
        : new Reference.Several(List.copyOf(terms));
  }

  private Reference everything(Form phrase, String className) {
    if (className.isEmpty()) {
      return new Reference.None(phrase);
    }
    Form where = phrase.part(0);
    if (!where.is("_")) {
      return resolve(
          Form.of(
              "np",
              Form.leaf("every"),
              Form.of("at", Form.of("noun", Form.leaf(className)), where)),
          className);
    }
    List<Term.Name> here =
        candidates(Description.ofClass(className), className).stream()
            .filter(this::isHere)
            .toList();
    return here.isEmpty() ? new Reference.None(phrase) : several(here);
  }

  private Reference counted(Form phrase, String className) {
    String determiner = phrase.text(0);
    boolean isOne = determiner.equals("the") || determiner.equals("this");
    if (isOne && phrase.part(1).is("noun") && phrase.part(1).text(0).equals(THING)) {
      // The thing is what was spoken of, and not the only one that is left.
      return latest(Form.leaf("it"), className);
    }
    boolean isCount = determiner.equals("count");
    boolean isDefinite = !determiner.equals("a") && !determiner.equals("some");
    Form nominal = phrase.part(isCount ? 2 : 1);
    Optional<Description> read = descriptions.of(nominal);
    if (read.isEmpty()) {
      return new Reference.None(phrase);
    }
    Description description = read.get();
    boolean mayFit = mayFit(description, className);
    // Of what is told by its class there may be very many, which nobody has to look at.
    boolean isTold =
        !mayFit || !isDefinite && description.named().isEmpty() && description.tests().isEmpty();
    List<Term.Name> certain =
        isTold && !description.className().isEmpty()
            ? List.of()
            : candidates(description, className);
    kinds(description, certain)
        .forEach(
            kind -> {
              kinds.remove(kind);
              kinds.add(kind);
            });
    if (!mayFit) {
      return new Reference.Mistyped(phrase);
    }
    boolean isNowhere = isOne && certain.isEmpty() && description.placed();
    List<Term.Name> candidates = isNowhere ? notElsewhere(description, className) : certain;
    if (!candidates.isEmpty() && (isNowhere || description.supposed())) {
      supposed++;
    }
    return switch (determiner) {
      case "a", "some" -> any(description, className, phrase, candidates);
      case "all", "every" -> all(description, className, phrase, candidates);
      case "count" -> exactly(description, phrase, candidates, wholeNumber(phrase.text(1)));
      case "this" ->
          definite(
              description, phrase, surroundings.present(candidates, kind(description, className)));
      default -> definite(description, phrase, candidates);
    };
  }

  private static String kind(Description description, String className) {
    return description.className().isEmpty() ? className : description.className();
  }

  /** The kinds of which the phrase speaks: its class, or those of whom it names. */
  private Set<String> kinds(Description description, List<Term.Name> candidates) {
    Set<String> spoken = new LinkedHashSet<>();
    if (!description.className().isEmpty()) {
      spoken.add(description.className());
    } else if (candidates.size() == 1) {
      Optional.ofNullable(situation.home().individuals().get(candidates.get(0).text())).stream()
          .flatMap(individual -> individual.classes().stream())
          .filter(kind -> !isWide(kind))
          .forEach(spoken::add);
    }
    return spoken;
  }

  /** Whether a kind tells hardly anything: everything is a thing. */
  private boolean isWide(String kind) {
    ClassDeclaration declared = situation.home().vocabulary().classes().get(kind);
    return declared == null || declared.ancestors().size() < 2;
  }

  /** The number; 0 while it was not said yet. */
  static int wholeNumber(String text) {
    return text.equals(Form.HOLE.head()) ? 0 : (int) Double.parseDouble(text);
  }

  private boolean mayFit(Description description, String className) {
    if (className.isEmpty()) {
      return true;
    }
    return description.named().isEmpty()
        ? description.className().isEmpty()
            || situation.home().vocabulary().mayBeBoth(description.className(), className)
        : description.named().stream().anyMatch(name -> relations.isA(name, className));
  }

  /** What fits the description and is of the class, in a stable order. */
  List<Term.Name> candidates(Description description, String className) {
    return candidates.of(description, className);
  }

  /** Things of which nobody knows that they are elsewhere: whoever says where they are may know. */
  private List<Term.Name> notElsewhere(Description description, String className) {
    Description anywhere = description.unconditional();
    return candidates(anywhere, className).stream()
        .filter(
            name ->
                description.conditions().stream()
                    .allMatch(
                        condition -> relations.mayHold(condition, Map.of(Description.IT, name))))
        .toList();
  }

  /** The things of which it is known that they are so. */
  public List<Term.Name> those(Reference.Any any) {
    return situation.facts().individuals(any.variable().className().orElse("")).stream()
        .filter(
            name ->
                any.conditions().stream()
                    .allMatch(
                        condition ->
                            relations.holds(condition, Map.of(any.variable().name(), name))))
        .toList();
  }

  boolean isSo(Description description, Term.Name candidate) {
    return candidates.isSo(description, candidate);
  }

  boolean isRelatedToAnything(PredicateDeclaration predicate, Term.Name candidate) {
    return relations.fits(predicate, 0, candidate)
        && situation.facts().individuals(Relations.typeOf(predicate, 1)).stream()
            .anyMatch(
                other ->
                    relations.holds(
                        new Formula.Atom(predicate.name(), List.of(candidate, other)), Map.of()));
  }

  private boolean isHere(Term.Name name) {
    return surroundings.isHere(name);
  }

  /** The thing of the class with which something here has to do now. */
  Optional<Term.Name> present(String className) {
    List<Term.Name> near =
        surroundings.present(situation.facts().individuals(className), className);
    return near.size() == 1 ? Optional.of(near.get(0)) : Optional.empty();
  }

  private List<Term.Name> withoutSpeaker(List<Term.Name> candidates) {
    Optional<Term.Name> speaker = situation.speaker().map(Term.Name::new);
    return speaker.filter(candidates::contains).isEmpty()
        ? candidates
        : candidates.stream().filter(one -> !one.equals(speaker.get())).toList();
  }

  private Reference definite(Description description, Form phrase, List<Term.Name> candidates) {
    // Nobody calls himself the person.
    List<Term.Name> ordered = candidates.size() > 1 ? withoutSpeaker(candidates) : candidates;
    if (description.choice() != Choice.UNSAID) {
      List<Term.Name> chosen = choosing.chosen(description, ordered);
      return chosen.isEmpty()
          ? new Reference.None(phrase)
          : chosen.size() == 1 ? single(chosen.get(0)) : new Reference.Open(phrase, chosen);
    }
    if (ordered.size() == 1) {
      return single(ordered.get(0));
    }
    if (ordered.isEmpty()) {
      return new Reference.None(phrase);
    }
    if (!description.placed()) {
      List<Term.Name> here = surroundings.here(ordered);
      if (here.size() == 1) {
        return single(here.get(0));
      }
      ordered = here.isEmpty() ? ordered : here;
    }
    List<Term.Name> among = ordered;
    Optional<Term.Name> last =
        situation.discourse().things().stream().filter(among::contains).findFirst();
    return last.or(() -> ofLatestKind(among))
        .map(this::single)
        .orElseGet(() -> new Reference.Open(phrase, among));
  }

  /** The only one of the kind that was spoken of last. */
  private Optional<Term.Name> ofLatestKind(List<Term.Name> candidates) {
    for (String kind : situation.discourse().classes()) {
      List<Term.Name> ofKind =
          candidates.stream().filter(candidate -> relations.isA(candidate, kind)).toList();
      if (ofKind.size() == 1) {
        return Optional.of(ofKind.get(0));
      }
      if (!ofKind.isEmpty()) {
        return Optional.empty();
      }
    }
    return Optional.empty();
  }

  private Reference all(
      Description description, String className, Form phrase, List<Term.Name> candidates) {
    if (description.choice() != Choice.UNSAID) {
      // Of all every second one, or the brightest ones: which these are nobody can tell.
      return new Reference.None(phrase);
    }
    if (description.everywhere()
        && description.tests().isEmpty()
        && description.named().isEmpty()) {
      return quantified(description, className, Reference.All::new);
    }
    if (candidates.isEmpty()) {
      return new Reference.None(phrase);
    }
    List<Term.Name> chosen = candidates;
    // Who says "every room" does not mean the one in which that is said.
    boolean arePlaces =
        situation.here().map(Term.Name::new).filter(candidates::contains).isPresent();
    if (!description.placed() && !arePlaces) {
      List<Term.Name> here = surroundings.here(candidates);
      boolean isBoundToRooms = candidates.stream().anyMatch(this::isSomewhere);
      if (!here.isEmpty()) {
        chosen = here;
      } else if (isBoundToRooms && situation.here().isPresent() && candidates.size() > 1) {
        return new Reference.Open(phrase, candidates);
      }
    }
    return together(chosen);
  }

  private Reference together(List<Term.Name> chosen) {
    if (chosen.size() == 1) {
      return single(chosen.get(0));
    }
    group.clear();
    group.addAll(chosen);
    return several(chosen);
  }

  private boolean isSomewhere(Term.Name name) {
    return relations.isA(name, "Device");
  }

  private Reference any(
      Description description, String className, Form phrase, List<Term.Name> candidates) {
    if (!description.named().isEmpty()) {
      // Who says "a cup" means a kind, rather than the one that is called so.
      supposed++;
      return definite(description, phrase, candidates);
    }
    if (description.className().isEmpty() && candidates.isEmpty()) {
      return new Reference.None(phrase);
    }
    return description.tests().isEmpty()
        ? quantified(description, className, Reference.Any::new)
        : candidates.isEmpty() ? new Reference.None(phrase) : single(candidates.get(0));
  }

  /** Makes a reference of a variable and conditions. */
  private interface Quantified {
    Reference of(TypedVariable variable, List<Formula> conditions);
  }

  private Reference quantified(Description description, String className, Quantified made) {
    String kind = description.className().isEmpty() ? className : description.className();
    String name = "x" + (variables == 0 ? "" : variables);
    variables++;
    Substitution named = new Substitution(Map.of(Description.IT, new Term.Variable(name)));
    return made.of(
        new TypedVariable(name, kind.isEmpty() ? Optional.empty() : Optional.of(kind)),
        description.conditions().stream().map(named::apply).toList());
  }

  private Reference exactly(
      Description description, Form phrase, List<Term.Name> candidates, int number) {
    if (description.choice() != Choice.UNSAID) {
      List<Term.Name> chosen = choosing.first(description, candidates, number);
      return chosen.size() == number && number > 0
          ? together(chosen)
          : chosen.isEmpty() ? new Reference.None(phrase) : new Reference.Open(phrase, chosen);
    }
    List<Term.Name> here = candidates.stream().filter(this::isHere).toList();
    List<Term.Name> fitting = here.size() == number ? here : candidates;
    if (fitting.size() == number) {
      return together(fitting);
    }
    return fitting.isEmpty() ? new Reference.None(phrase) : new Reference.Open(phrase, fitting);
  }

  /**
   * What a phrase says of a variable, for questions: its class and conditions.
   *
   * @return empty when something in the phrase refers to nothing
   */
  public Optional<Asked> asked(Form nominal, Form where, String variable) {
    if (where.is("both")) {
      return asked(
          Form.of("at", Form.of("instate", where.part(0), nominal), where.part(1)),
          Form.HOLE,
          variable);
    }
    Form whole =
        where.is("_")
            ? nominal
            : Form.of(placeOrState(where), first(where, nominal), second(where, nominal));
    return descriptions
        .of(whole)
        .filter(description -> description.tests().isEmpty())
        .flatMap(this::withChoice)
        .map(
            description -> {
              Substitution named =
                  new Substitution(Map.of(Description.IT, new Term.Variable(variable)));
              return new Asked(
                  description.className(),
                  description.named(),
                  description.conditions().stream().map(named::apply).toList());
            });
  }

  /** Which of them is meant is one condition more. */
  private Optional<Description> withChoice(Description description) {
    return description.choice() instanceof Choice.Extreme extreme
        ? choosing
            .condition(extreme, description.className(), description.conditions())
            .map(description::with)
        : Optional.of(description);
  }

  private static String placeOrState(Form where) {
    return isState(where) ? "instate" : "at";
  }

  private static boolean isState(Form form) {
    return form.is("state") || form.is("not") || form.is("and");
  }

  private static Form first(Form where, Form nominal) {
    return isState(where) ? where : nominal;
  }

  private static Form second(Form where, Form nominal) {
    return isState(where) ? nominal : where;
  }

  /** What is asked of a variable. */
  public record Asked(String className, List<Term.Name> named, List<Formula> conditions) {
    public Asked {
      named = List.copyOf(named);
      conditions = List.copyOf(conditions);
    }
  }
}
