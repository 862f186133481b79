/**
 * What others want of the central agent about goals, their ends and stories, in messages or in
 * people's words as they are heard, and what it tells of the goals of others. Requests, words and
 * entries of stories flow in; answers flow out. It decides nothing about a goal's course.
 */
@NullMarked
package org.maestro.agents.centre;

import org.jspecify.annotations.NullMarked;
