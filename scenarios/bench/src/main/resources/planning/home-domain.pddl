; Robots, cameras, lamps, shutters and doors of a home, for the benchmark of the planner.
(define (domain home)
  (:requirements :strips :typing :action-costs)
  (:types
    agent room lux-level kind grip locatable - object
    robot camera light sensor shutter door - agent
    item person - locatable)
  (:predicates
    (online ?a - agent)
    (light-in ?a - light ?r - room)
    (shutter-in ?a - shutter ?r - room)
    (off ?a - light)
    (on ?a - light)
    (up ?a - shutter)
    (down ?a - shutter)
    (level ?r - room ?x - lux-level)
    (known-level ?r - room ?x - lux-level)
    (raises ?a - agent ?x - lux-level ?y - lux-level)
    (senses ?a - sensor ?r - room)
    (covers ?a - camera ?r - room)
    (at ?o - locatable ?r - room)
    (sees-at ?a - agent ?x - lux-level)
    (located ?o - locatable)
    (can-see ?a - agent ?o - locatable)
    (has-eye ?a - robot)
    (robot-at ?a - robot ?r - room)
    (robot-kind ?a - robot ?k - kind)
    (passable ?r - room ?s - room)
    (door-between ?a - door ?r - room ?s - room)
    (shut ?a - door)
    (ajar ?a - door)
    (unlocked ?a - door)
    (hand-free ?a - robot)
    (holding ?a - robot ?o - item)
    (needs-grip ?o - item ?g - grip)
    (grips ?a - robot ?g - grip)
    (next-to ?o - item ?t - locatable)
    (neighbour ?o - item ?t - locatable)
  )
  (:functions (total-cost) - number
    (on-cost ?a - light) - number
    (off-cost ?a - light) - number
    (shutter-cost ?a - shutter) - number
    (measure-cost ?a - sensor) - number
    (observe-cost ?a - agent) - number
    (door-cost ?a - door) - number
    (move-cost ?k - kind ?r - room ?s - room) - number
    (pick-cost ?a - robot) - number
    (place-cost ?a - robot) - number
  )
  (:action adjust-light-on
    :parameters (?a - light ?r - room ?x - lux-level ?y - lux-level)
    :precondition (and (online ?a) (light-in ?a ?r) (off ?a) (level ?r ?x) (raises ?a ?x ?y))
    :effect (and (not (off ?a)) (not (level ?r ?x)) (not (known-level ?r ?x)) (on ?a) (level ?r ?y) (increase (total-cost) (on-cost ?a))))
  (:action adjust-light-off
    :parameters (?a - light ?r - room ?x - lux-level ?y - lux-level)
    :precondition (and (online ?a) (light-in ?a ?r) (on ?a) (level ?r ?x) (raises ?a ?y ?x))
    :effect (and (not (on ?a)) (not (level ?r ?x)) (not (known-level ?r ?x)) (off ?a) (level ?r ?y) (increase (total-cost) (off-cost ?a))))
  (:action open-shutter
    :parameters (?a - shutter ?r - room ?x - lux-level ?y - lux-level)
    :precondition (and (online ?a) (shutter-in ?a ?r) (down ?a) (level ?r ?x) (raises ?a ?x ?y))
    :effect (and (not (down ?a)) (not (level ?r ?x)) (not (known-level ?r ?x)) (up ?a) (level ?r ?y) (increase (total-cost) (shutter-cost ?a))))
  (:action close-shutter
    :parameters (?a - shutter ?r - room ?x - lux-level ?y - lux-level)
    :precondition (and (online ?a) (shutter-in ?a ?r) (up ?a) (level ?r ?x) (raises ?a ?y ?x))
    :effect (and (not (up ?a)) (not (level ?r ?x)) (not (known-level ?r ?x)) (down ?a) (level ?r ?y) (increase (total-cost) (shutter-cost ?a))))
  (:action measure-illumination
    :parameters (?a - sensor ?r - room ?x - lux-level)
    :precondition (and (online ?a) (senses ?a ?r) (level ?r ?x))
    :effect (and  (known-level ?r ?x) (increase (total-cost) (measure-cost ?a))))
  (:action observe-object
    :parameters (?a - camera ?o - locatable ?r - room ?x - lux-level)
    :precondition (and (online ?a) (covers ?a ?r) (at ?o ?r) (level ?r ?x) (known-level ?r ?x) (sees-at ?a ?x))
    :effect (and  (located ?o) (can-see ?a ?o) (increase (total-cost) (observe-cost ?a))))
  (:action look
    :parameters (?a - robot ?o - locatable ?r - room ?x - lux-level)
    :precondition (and (online ?a) (has-eye ?a) (robot-at ?a ?r) (at ?o ?r) (level ?r ?x) (known-level ?r ?x) (sees-at ?a ?x))
    :effect (and  (located ?o) (can-see ?a ?o) (increase (total-cost) (observe-cost ?a))))
  (:action open-door
    :parameters (?a - door ?r - room ?s - room)
    :precondition (and (online ?a) (door-between ?a ?r ?s) (shut ?a) (unlocked ?a))
    :effect (and (not (shut ?a)) (ajar ?a) (passable ?r ?s) (passable ?s ?r) (increase (total-cost) (door-cost ?a))))
  (:action close-door
    :parameters (?a - door ?r - room ?s - room)
    :precondition (and (online ?a) (door-between ?a ?r ?s) (ajar ?a))
    :effect (and (not (ajar ?a)) (not (passable ?r ?s)) (not (passable ?s ?r)) (shut ?a) (increase (total-cost) (door-cost ?a))))
  (:action pick
    :parameters (?a - robot ?o - item ?g - grip ?r - room)
    :precondition (and (online ?a) (robot-at ?a ?r) (hand-free ?a) (at ?o ?r) (located ?o) (needs-grip ?o ?g) (grips ?a ?g))
    :effect (and (not (hand-free ?a)) (not (at ?o ?r)) (holding ?a ?o) (increase (total-cost) (pick-cost ?a))))
  (:action pick-from
    :parameters (?a - robot ?o - item ?g - grip ?t - locatable ?r - room)
    :precondition (and (online ?a) (robot-at ?a ?r) (hand-free ?a) (next-to ?o ?t) (at ?t ?r) (needs-grip ?o ?g) (grips ?a ?g))
    :effect (and (not (hand-free ?a)) (not (next-to ?o ?t)) (holding ?a ?o) (increase (total-cost) (pick-cost ?a))))
  (:action place
    :parameters (?a - robot ?o - item ?r - room)
    :precondition (and (online ?a) (robot-at ?a ?r) (holding ?a ?o))
    :effect (and (not (holding ?a ?o)) (hand-free ?a) (at ?o ?r) (increase (total-cost) (place-cost ?a))))
  (:action place-next
    :parameters (?a - robot ?o - item ?t - locatable ?r - room)
    :precondition (and (online ?a) (robot-at ?a ?r) (holding ?a ?o) (at ?t ?r) (located ?t) (neighbour ?o ?t))
    :effect (and (not (holding ?a ?o)) (hand-free ?a) (next-to ?o ?t) (increase (total-cost) (place-cost ?a))))
  (:action move
    :parameters (?a - robot ?k - kind ?r - room ?s - room)
    :precondition (and (online ?a) (robot-kind ?a ?k) (robot-at ?a ?r) (passable ?r ?s))
    :effect (and (not (robot-at ?a ?r)) (robot-at ?a ?s) (increase (total-cost) (move-cost ?k ?r ?s))))
)
