package org.maestro.knowledge.api;

/**
 * The place of a message among all that was heard of one member, in the order in which the member
 * sent it. Clocks have no part in it.
 *
 * @param listener who counted; moments of different listeners have no order
 * @param number later ones are higher
 */
public record Moment(String listener, long number) {

  public boolean isAfter(Moment other) {
    return listener.equals(other.listener) && number > other.number;
  }
}
