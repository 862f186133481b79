/**
 * Conversations with persons of the home: what somebody in a room writes comes in, what becomes of
 * it goes out as events. Who answers is an {@link org.maestro.console.chat.Interlocutor}; the one
 * that is here understands goals and questions in MAESTRO-SL and in the words of the home, and
 * another one can take its place without a change of API and page.
 */
@NullMarked
package org.maestro.console.chat;

import org.jspecify.annotations.NullMarked;
