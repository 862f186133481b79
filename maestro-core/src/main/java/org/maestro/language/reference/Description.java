package org.maestro.language.reference;

import java.util.List;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * What a nominal says of things: their class, or their names, and conditions over {@link #IT}.
 *
 * @param named those that are called so; empty when they are told by their class
 * @param className "" for any
 * @param conditions that formulas can say
 * @param tests that only the situation can tell, such as which is the nearest
 * @param placed whether it is said where they are
 * @param everywhere whether it is said that wherever is meant
 * @param supposed whether it is only supposed, as nobody knows otherwise
 * @param choice which of several is meant
 */
record Description(
    List<Term.Name> named,
    String className,
    List<Formula> conditions,
    List<Test> tests,
    boolean placed,
    boolean everywhere,
    boolean supposed,
    Choice choice) {
  /** The variable of conditions. */
  static final String IT = "x";

  static final Term.Variable VARIABLE = new Term.Variable(IT);

  /** A condition for which there is no formula. */
  interface Test {
    boolean holds(Term.Name candidate);
  }

  Description {
    named = List.copyOf(named);
    conditions = List.copyOf(conditions);
    tests = List.copyOf(tests);
  }

  static Description ofClass(String name) {
    return new Description(
        List.of(), name, List.of(), List.of(), false, false, false, Choice.UNSAID);
  }

  static Description ofNames(Form names) {
    return new Description(
        names.parts().stream().map(part -> new Term.Name(part.head())).toList(),
        "",
        List.of(),
        List.of(),
        false,
        false,
        false,
        Choice.UNSAID);
  }

  Description with(Formula condition) {
    return new Description(
        named,
        className,
        added(conditions, condition),
        tests,
        placed,
        everywhere,
        supposed,
        choice);
  }

  Description with(Test test) {
    return new Description(
        named, className, conditions, added(tests, test), placed, everywhere, supposed, choice);
  }

  Description placedSomewhere() {
    return new Description(named, className, conditions, tests, true, everywhere, supposed, choice);
  }

  Description anywhere() {
    return new Description(named, className, conditions, tests, true, true, supposed, choice);
  }

  Description unconditional() {
    return new Description(
        named, className, List.of(), tests, placed, everywhere, supposed, choice);
  }

  Description supposing() {
    return new Description(named, className, conditions, tests, true, everywhere, true, choice);
  }

  Description choosing(Choice which) {
    return new Description(
        named, className, conditions, tests, placed, everywhere, supposed, which);
  }

  private static <T> List<T> added(List<T> list, T one) {
    return Stream.concat(list.stream(), Stream.of(one)).toList();
  }
}
