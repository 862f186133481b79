package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** One fault at a time in a domain and a problem that are in order. */
class PddlFaultsTest {
  private static final String DOMAIN =
      """
      (define (domain lamps)
      (:requirements :adl :fluents)
      (:types lamp room)
      (:constants hall - room)
      (:predicates (on ?l - lamp) (in ?l - lamp ?r - room))
      (:functions (cost) - number (gain ?l - lamp))
      (:action switch
      :parameters (?l - lamp)
      :precondition (not (on ?l))
      :effect (and (on ?l) (increase (cost) 1))))
      """;
  private static final String PROBLEM =
      """
      (define (problem p)
      (:domain lamps)
      (:objects a b - lamp)
      (:init (in a hall) (= (cost) 0))
      (:goal (on a))
      (:metric minimize (cost)))
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(define (domain lamps) | (define (domain) | 1:1: Expected (define (domain NAME) ...).",
        "(define (domain lamps) | (defined (domain lamps) | 1:1: Expected (define (domain NAME) ...).",
        ":adl | :durative-actions | 2:16: The requirement :durative-actions is not supported.",
        "(:types lamp room) | (:types lamp room -) | 3:19: Expected a type after '-', found"
            + " nothing.",
        "(:types lamp room) | (:types lamp - room room - lamp) | 4:13: The type room is below"
            + " itself.",
        "(:types lamp room) | (:types lamp ?room) | 3:14: Expected a name, found ?room.",
        "(:types lamp room) | :types | 3:1: Expected a section such as (:init ...), found :types.",
        "(:types lamp room) | ((:types)) | 3:1: Expected a section such as (:action ...).",
        "hall - room | hall - place | 4:13: There is no type place; declare it in (:types ...).",
        "hall - room | hall - (neither room) | 4:20: Expected a type or (either ...).",
        "hall - room | hall - (either) | 4:20: Expected a type or (either ...).",
        "(on ?l - lamp) | () | 5:14: Expected a predicate's name, found an empty list.",
        "(on ?l - lamp) | (on ?l - light) | 5:18: There is no type light; declare it in (:types"
            + " ...).",
        "(on ?l - lamp) | (on ?l - lamp) (on) | 5:30: The predicate on is declared twice.",
        "(on ?l - lamp) | (on l - lamp) | 5:18: Expected a variable, found l.",
        "(cost) - number | (cost) - lamp | 6:22: Functions have to be numbers, found lamp.",
        "(gain ?l - lamp)) | (gain ?l - lamp) -) | 6:46: Functions have to be numbers, found -.",
        "(:action switch | (:action | 8:1: Expected an action's name, found :parameters.",
        ":precondition (not (on ?l)) | :condition (on ?l) | 9:1: :condition is not supported in an"
            + " action.",
        ":precondition (not (on ?l)) | :effect (not (on ?l)) | 10:1: :effect is there twice.",
        "(increase (cost) 1))) | (increase (cost) 1)) :parameters) | 10:43: Expected something"
            + " after :parameters.",
        ":precondition (not (on ?l)) | :precondition (not) | 9:15: Expected one thing after not.",
        ":precondition (not (on ?l)) | :precondition ((on ?l)) | 9:15: Expected a condition, found"
            + " a list of lists.",
        ":precondition (not (on ?l)) | :precondition (imply (on ?l)) | 9:15: Expected (imply"
            + " condition condition).",
        ":precondition (not (on ?l)) | :precondition (imply (on ?l) (of ?l)) | 9:31: There is no"
            + " predicate of.",
        ":precondition (not (on ?l)) | :precondition (or (on ?l) (on ?m)) | 9:31: There is no"
            + " parameter ?m here.",
        ":precondition (not (on ?l)) | :precondition (and (forall (?m - lamp) (on ?m)) (on ?m)) |"
            + " 9:53: There is no parameter ?m here.",
        ":precondition (not (on ?l)) | :precondition (forall (?m - lamp)) | 9:15: Expected (forall"
            + " (?variable - type ...) condition).",
        ":precondition (not (on ?l)) | :precondition (exists (?m - light) (on ?m)) | 9:24: There"
            + " is no type light; declare it in (:types ...).",
        ":precondition (not (on ?l)) | :precondition (= ?l) | 9:15: Expected two things to"
            + " compare.",
        ":precondition (not (on ?l)) | :precondition (not (= ?l 3)) | 9:23: Expected a"
            + " function, found ?l.",
        ":precondition (not (on ?l)) | :precondition (> (gain ?l) (+)) | 9:28: Expected amounts"
            + " after +.",
        ":precondition (not (on ?l)) | :precondition (> (gain ?l) (* 2)) | 9:28: Expected two"
            + " amounts after *.",
        ":precondition (not (on ?l)) | :precondition (> (gain ?l) (% 2)) | 9:29: There is no"
            + " function %.",
        ":precondition (not (on ?l)) | :precondition (on ?l ?l) | 9:16: on takes 1 arguments, found"
            + " 2.",
        ":precondition (not (on ?l)) | :precondition (on hall) | 9:19: on takes an object of the"
            + " type lamp here, and hall is none.",
        "(and (on ?l) | (and ((on ?l)) | 10:14: Expected an effect, found a list of lists.",
        "(and (on ?l) | (and (or (on ?l) (on ?l)) | 10:14: (or ...) in an effect is not supported.",
        "(and (on ?l) | (and (not (of ?l)) | 10:20: There is no predicate of.",
        "(and (on ?l) | (and (when (of ?l) (on ?l)) | 10:21: There is no predicate of.",
        "(and (on ?l) | (and (when (on ?l) (of ?l)) | 10:29: There is no predicate of.",
        "(and (on ?l) | (and (when (on ?l) (and (when (on ?l) (on ?l)))) | 10:33: (when ...) within"
            + " (when ...) is not supported.",
        "(and (on ?l) | (and (forall (?m - lamp) (of ?m)) | 10:35: There is no predicate of.",
        "(increase (cost) 1) | (increase (cost)) | 10:22: Expected (increase function amount).",
        "(increase (cost) 1) | (increase (costs) 1) | 10:33: There is no function costs.",
        "(increase (cost) 1) | (increase (cost) (gain)) | 10:40: gain takes 1 arguments, found 0.",
      })
  void inTheDomain(String right, String wrong, String message) {
    assertThat(DOMAIN).containsOnlyOnce(right);
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN.replace(right, wrong), "p", PROBLEM))
        .isInstanceOf(PddlException.class)
        .hasMessage("d:" + message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(problem p) | (problem p q) | 1:1: Expected (define (problem NAME) ...).",
        "(:domain lamps) | (:domain) | 2:1: The problem is of the domain , not of lamps.",
        "(:domain lamps) | (:domain lamps) (:requirements :preferences) | 2:32: The requirement"
            + " :preferences is not supported.",
        "a b - lamp | a b - light | 3:11: There is no type light; declare it in (:types ...).",
        "(in a hall) | in | 4:8: Expected a fact, found in.",
        "(in a hall) | () | 4:8: Expected a fact.",
        "(in a hall) | (at 3 (on a)) | 4:8: Timed facts are not supported.",
        "(in a hall) | (in ?a hall) | 4:12: There is no parameter ?a here.",
        "(= (cost) 0) | (= (cost)) | 4:20: Expected (= function number).",
        "(= (cost) 0) | (= (cost) zero) | 4:30: Expected a number, found zero.",
        "(:goal (on a)) | `` | 1:1: The problem has no (:goal ...).",
        "(:goal (on a)) | (:goal) | 5:1: Expected one condition in (:goal ...).",
        "(:goal (on a)) | (:goal (on a) (on b)) | 5:1: Expected one condition in (:goal ...).",
        "minimize | maximize | 6:10: Only minimize is supported, found maximize.",
        "minimize (cost) | minimize | 6:1: Expected (:metric minimize (function)).",
        "minimize (cost) | minimize (gain a) | 6:19: Functions of objects are not supported in a"
            + " metric.",
        "minimize (cost) | minimize (+ (cost) (dear)) | 6:30: There is no function dear.",
        "minimize (cost) | minimize (* (cost) (cost)) | 6:20: There is no function *.",
        "(cost))) | (cost)) (:metric minimize (cost))) | 6:27: (:metric ...) is there twice.",
      })
  void inTheProblem(String right, String wrong, String message) {
    assertThat(PROBLEM).containsOnlyOnce(right);
    assertThatThrownBy(() -> PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace(right, wrong)))
        .isInstanceOf(PddlException.class)
        .hasMessage("p:" + message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(cost) | 1",
        "cost | 1",
        "(+ (cost) (cost)) | 2",
        "(* 2.5 (cost)) | 2.5",
        "(* (cost) 2.5) | 2.5",
        "(+ (* 2 (* (cost) 3)) (cost)) | 7",
      })
  void aMetricIsASumOfFunctions(String metric, String factor) {
    var task =
        PddlReader.parse(
            "d", DOMAIN, "p", PROBLEM.replace("minimize (cost)", "minimize " + metric));
    int cost = task.functions().indexOf("cost");
    assertThat(task.metric()).containsOnlyKeys(cost);
    assertThat(task.metric().get(cost)).isEqualByComparingTo(factor);
  }
}
