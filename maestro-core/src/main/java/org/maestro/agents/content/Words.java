package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.sl.Content;
import org.maestro.sl.Content.Argument;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Builds and takes apart the content of messages: operators with named arguments. */
public final class Words {
  /** The content language of all messages. */
  public static final String LANGUAGE = "MAESTRO-SL";

  /** The ontology slot of all messages, as in the paper's example. */
  public static final String ONTOLOGY = "WorldModel";

  private final List<Argument> arguments;

  private Words(List<Argument> arguments) {
    this.arguments = arguments;
  }

  /** Reads the arguments of a content element or of a named argument. */
  public static Words of(Content content) {
    return new Words(content.arguments());
  }

  public static Words of(Argument.Named named) {
    return new Words(named.arguments());
  }

  /** The elements of a message's content; throws {@link org.maestro.sl.SlSyntaxException}. */
  public static List<Content> parse(String content) {
    return SlParser.content(content == null ? "" : content);
  }

  public static String print(Content... contents) {
    return print(List.of(contents));
  }

  public static String print(List<Content> contents) {
    return SlPrinter.print(contents);
  }

  public static Content content(String operator, Argument... arguments) {
    return new Content(operator, List.of(arguments));
  }

  public static Argument.Named named(String name, Argument... arguments) {
    return new Argument.Named(name, List.of(arguments));
  }

  public static Argument.Named named(String name, List<? extends Argument> arguments) {
    return new Argument.Named(name, List.copyOf(arguments));
  }

  /** As a text when it is no name of the language. */
  public static Argument name(String text) {
    return new Argument.OfTerm(Term.named(text));
  }

  public static Argument text(String text) {
    return new Argument.OfTerm(new Term.Text(text));
  }

  public static Argument number(double value) {
    return new Argument.OfTerm(new Term.Number(value));
  }

  public static Argument term(Term term) {
    return new Argument.OfTerm(term);
  }

  public static Argument formula(Formula formula) {
    return new Argument.OfFormula(formula);
  }

  /** {@code (:name value)} for each entry, inside {@code (:title ...)}. */
  public static Argument.Named terms(String title, Map<String, Term> terms) {
    return named(
        title, terms.entrySet().stream().map(e -> named(e.getKey(), term(e.getValue()))).toList());
  }

  /** The terms under that name, as plain words; none where there is no such argument. */
  public List<String> strings(String name) {
    return find(name).map(Words::terms).orElse(List.of()).stream().map(Words::plain).toList();
  }

  public Optional<Words> find(String name) {
    return named(name).map(Words::of);
  }

  public Optional<Argument.Named> named(String name) {
    return all().stream().filter(n -> n.name().equals(name)).findFirst();
  }

  /** Whether all arguments, if there are any, are of these names. */
  public boolean hasNothingBut(String... names) {
    return arguments.stream()
        .allMatch(
            argument -> argument instanceof Argument.Named n && Set.of(names).contains(n.name()));
  }

  /** All named arguments, in order. */
  public List<Argument.Named> all() {
    return arguments.stream()
        .filter(Argument.Named.class::isInstance)
        .map(Argument.Named.class::cast)
        .toList();
  }

  /** The plain terms among the arguments, in order. */
  public List<Term> terms() {
    List<Term> terms = new ArrayList<>();
    for (Argument argument : arguments) {
      if (argument instanceof Argument.OfTerm ofTerm) {
        terms.add(ofTerm.term());
      }
    }
    return terms;
  }

  public Optional<Formula> formula() {
    return arguments.stream()
        .filter(Argument.OfFormula.class::isInstance)
        .map(a -> ((Argument.OfFormula) a).formula())
        .findFirst();
  }

  /** The first term of a named argument. */
  public Optional<Term> term(String name) {
    return find(name).flatMap(words -> words.terms().stream().findFirst());
  }

  /** The first term of a named argument as plain text: a name, an IRI, a number or a string. */
  public Optional<String> string(String name) {
    return term(name).map(Words::plain);
  }

  public double number(String name, double otherwise) {
    return term(name)
        .filter(Term.Number.class::isInstance)
        .map(term -> ((Term.Number) term).value())
        .orElse(otherwise);
  }

  /** What {@link #terms(String, Map)} wrote. */
  public Map<String, Term> termsOf(String title) {
    Map<String, Term> terms = new LinkedHashMap<>();
    find(title)
        .ifPresent(
            words ->
                words
                    .all()
                    .forEach(
                        n ->
                            Words.of(n).terms().stream()
                                .findFirst()
                                .ifPresent(term -> terms.put(n.name(), term))));
    return terms;
  }

  public static String plain(Term term) {
    if (term instanceof Term.Name name) {
      return name.text();
    }
    if (term instanceof Term.Text text) {
      return text.value();
    }
    if (term instanceof Term.Iri iri) {
      return iri.text();
    }
    return SlPrinter.print(term);
  }
}
